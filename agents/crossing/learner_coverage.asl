// Coverage learner: learns which meetings with the AV cover what no test has covered, where new bins of
// situations are rewarded (jaywalk learn). It crosses at once, or chooses how to move, in which row and
// how many cells ahead of the AV, one after another. It knows nothing of earlier tests.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }
{ include("shared/reckoning.asl") }
{ include("shared/meetings.asl") }

!exercise_av.

+!exercise_av <- ?at(_, Y); +started(Y); !begin.

@at_once[learned(begin)] +!begin <- !cross_road.
@in_time[learned(begin)] +!begin <- !set_out; !go_for_a_meeting.

+!go_for_a_meeting : possible(_)
  <- !choose_how;
     !choose_row;
     !choose_ahead;
     ?how(How);
     ?row(Row);
     ?ahead(Ahead);
     !meet(meeting(Row, Ahead, How)).
+!go_for_a_meeting <- !walk; !go_for_a_meeting.

@across[learned(how)] +!choose_how   : possible(meeting(_, _, across))   <- +how(across).
@along[learned(how)] +!choose_how    : possible(meeting(_, _, along))    <- +how(along).
@standing[learned(how)] +!choose_how : possible(meeting(_, _, standing)) <- +how(standing).

@first_row[learned(row)] +!choose_row  : possible_row(0, Row) <- +row(Row).
@second_row[learned(row)] +!choose_row : possible_row(1, Row) <- +row(Row).
@third_row[learned(row)] +!choose_row  : possible_row(2, Row) <- +row(Row).
@fourth_row[learned(row)] +!choose_row : possible_row(3, Row) <- +row(Row).

@one_ahead[learned(ahead)] +!choose_ahead   : possible_ahead(1) <- +ahead(1).
@two_ahead[learned(ahead)] +!choose_ahead   : possible_ahead(2) <- +ahead(2).
@three_ahead[learned(ahead)] +!choose_ahead : possible_ahead(3) <- +ahead(3).
@four_ahead[learned(ahead)] +!choose_ahead  : possible_ahead(4) <- +ahead(4).
@five_ahead[learned(ahead)] +!choose_ahead  : possible_ahead(5) <- +ahead(5).
@six_ahead[learned(ahead)] +!choose_ahead   : possible_ahead(6) <- +ahead(6).

possible_row(I, Row) :-
  zone_rows(First, _) & Row = First + I & how(How) & possible(meeting(Row, _, How)).
possible_ahead(Ahead) :- row(Row) & how(How) & possible(meeting(Row, Ahead, How)).

// From which side it comes, in which cell or sixth of the road it started, and what it has chosen
// already.
observation(begin, [Side, Y]) :- side(Side) & started(Y).
observation(how, [Side, Band]) :- side(Side) & band(Band).
observation(row, [Side, Band, How]) :- side(Side) & band(Band) & number_of_how(How).
observation(ahead, [Side, Band, How, Row]) :-
  side(Side) & band(Band) & number_of_how(How) & row(Row).

side(0) :- way_across(right).
side(1) :- way_across(left).
band(B) :- started(Y) & grid(_, Cells) & B = math.floor(6 * (Y + 0.5) / Cells).
number_of_how(0) :- how(across).
number_of_how(1) :- how(along).
number_of_how(2) :- how(standing).
