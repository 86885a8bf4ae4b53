// Coverage-directed: a pedestrian who meets the AV as soon as that is possible, unless it believes
// what earlier tests have covered. With such beliefs (experiment.feedback) it aims for a gap: a meeting
// with the AV (in which row of its way, how many cells ahead of it, walking across, along or standing)
// that covers bins which those tests have not.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }
{ include("shared/reckoning.asl") }
{ include("shared/meetings.asl") }

!exercise_av.

+!exercise_av <- ?at(_, Y); +started(Y); !set_out; !go_for_a_hole.

+!go_for_a_hole : hole(Meeting)  <- !meet(Meeting).
+!go_for_a_hole : meets_av_in(_) <- !cross_road.
+!go_for_a_hole                  <- !walk; !go_for_a_hole.

// A random one of the meetings that are still possible and have the fewest covered bins.
hole(Meeting) :-
  is_covered(_, _) & .findall(option(Old, M), possible(M) & bins_covered(M, Old), All) &
  .min(All, option(Least, _)) & .findall(M, .member(option(Least, M), All), Best) &
  .random(Best, Chosen) & Meeting = Chosen.

is_covered(Item, Bin) :- covered(Item, Bin, _).  // jaywalk: allow unknown-belief

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
