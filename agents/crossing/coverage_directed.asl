// Coverage-directed: a pedestrian who meets the AV as soon as that is possible, unless it is told
// what earlier tests have covered (experiment.feedback). Then it goes for a hole: a meeting in a row
// of the AV's way, so many cells ahead of the AV, walking across, along or standing, that covers
// what they have not.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }
{ include("shared/reckoning.asl") }

!exercise_av.

+!exercise_av <- ?at(_, Y); +started(Y); !set_out; !go_for_a_hole.

+!go_for_a_hole : hole(Meeting)  <- !meet(Meeting).
+!go_for_a_hole : meets_av_in(_) <- !cross_road.
+!go_for_a_hole                  <- !walk; !go_for_a_hole.

// Walk, or wait, until crossing leads to the meeting.
+!meet(Meeting) : slack(Meeting, S) & used_up(S) & Meeting = meeting(Row, _, How)
  <- !cross_to(Row);
     !go_on(How);
     !cross_road.
+!meet(Meeting) : slack(Meeting, S) & step_for(S, Way) <- !step(Way); !meet(Meeting).
+!meet(_) <- !cross_road.

+!step(stay) <- stay.
+!step(Way)  <- move(Way).

+!cross_to(Row) : at(X, _) & walking_speed(W) & math.abs(X - Row) <= W / 2.
+!cross_to(Row) : at(X, _) & X < Row <- move(right); !cross_to(Row).
+!cross_to(Row)                      <- move(left); !cross_to(Row).

+!go_on(across).
+!go_on(standing) <- stay.
+!go_on(along)    <- move(forward).

// One of the meetings that are still possible and have the fewest bins that are covered already.
hole(Meeting) :-
  is_covered(_, _) & .findall(option(Old, M), possible(M) & bins_covered(M, Old), All) &
  .min(All, option(Least, _)) & .findall(M, .member(option(Least, M), All), Best) &
  .random(Best, Chosen) & Meeting = Chosen.

is_covered(Item, Bin) :- covered(Item, Bin, _).  // jaywalk: allow unknown-belief

possible(meeting(Row, Ahead, How)) :-
  zone_rows(First, Last) & .range(Row, First, Last) & zone_ahead(From, To) &
  .range(Ahead, From, To) & manner(How, _, _, _) & not met_before(Row, Ahead, How) &
  slack(meeting(Row, Ahead, How), S) & can_use_up(S).

// Already in the zone a tick earlier, when the AV was its way of a tick further back.
met_before(Row, Ahead, How) :-
  av_speed(V) & zone_ahead(_, To) & Ahead + V <= To & manner(How, _, More, _) & walking_speed(W) &
  rows_in(Row, Rows) & Rows - W * (1 - More) >= -0.5.

// How many rows into the zone a row is, from where the pedestrian comes.
rows_in(Row, N) :- way_across(right) & zone_rows(First, _) & N = Row - First.
rows_in(Row, N) :- way_across(left) & zone_rows(_, Last) & N = Last - Row.

// How to be when the AV comes, by its bins when coming from the left and from the right; the ticks
// that it takes beyond crossing, and the steps that it leads on.
manner(across, [1, 2], 0, 0).
manner(along, [3, 3], 1, 1).
manner(standing, [4, 4], 1, 0).

// How much nearer the AV must be, in cells, when the pedestrian begins to cross. In a tick the AV
// comes nearer by V cells, by a step W less if the pedestrian walks forward, by W more if it walks back.
slack(meeting(Row, Ahead, How), S) :-
  manner(How, _, More, Steps) & at(X, Y) & av(AvY) & av_speed(V) & walking_speed(W) &
  rows_to(X, Row, Row, N) & ticks_to_walk(N, T) &
  S = Y + Steps * W - AvY - V * (T + More - 1) - Ahead.

// A meeting is meant to the cell.
used_up(S)    :- S >= -0.5 & S <= 0.5.
can_use_up(S) :- used_up(S).
can_use_up(S) :-
  S > 0.5 & av_speed(V) & walking_speed(W) & S + 0.5 >= math.ceil((S - 0.5) / (V + W)) * (V - W).

step_for(S, stay)    :- av_speed(V) & can_use_up(S - V).
step_for(S, forward) :- free(forward) & av_speed(V) & walking_speed(W) & can_use_up(S - V + W).
step_for(S, back)    :- free(back) & av_speed(V) & walking_speed(W) & can_use_up(S - V - W).

// How many of the meeting's bins earlier tests have covered.
bins_covered(meeting(Row, Ahead, How), N) :-
  point_bin(Row, P) & ttc_bin(Ahead, T) & band_bin(B) & approach_bin(How, A) &
  .count(is_covered(point_and_ttc, 5 * (P - 1) + T), N1) &
  .count(is_covered(point_and_approach, 4 * (P - 1) + A), N2) &
  .count(is_covered(band_and_point, 5 * (B - 1) + P), N3) & N = N1 + N2 + N3.

// The bins, from 1, as the test bench counts them.
point_bin(Row, 1) :- av_rows(First, _) & Row < First.
point_bin(Row, 5) :- av_rows(_, Last) & Row > Last.
point_bin(Row, P) :-
  av_rows(First, Last) & Row >= First & Row <= Last &
  Share = (Row + 0.5 - First) / (Last - First + 1) & point_of(Share, P).
point_of(Share, 2) :- Share < 0.375.
point_of(Share, 3) :- Share >= 0.375 & Share < 0.625.
point_of(Share, 4) :- Share >= 0.625.

ttc_bin(Ahead, T) :-
  av_speed(V) & tick_length(S) & T = 1 + math.min(4, math.floor((Ahead - 0.5) / V * S / 0.2)).

band_bin(B) :- started(Y) & grid(_, Cells) & B = 1 + math.floor(6 * (Y + 0.5) / Cells).

approach_bin(How, A) :- way_across(right) & manner(How, [A, _], _, _).
approach_bin(How, A) :- way_across(left) & manner(How, [_, A], _, _).
