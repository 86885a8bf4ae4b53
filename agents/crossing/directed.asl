// Directed: a pedestrian with a given assertion of the AV to exercise, and a desire for each assertion
// that it knows. One needs a pedestrian close in front of the AV, one needs a pedestrian that stands in
// the AV's way in good time, one needs a pedestrian that has crossed the AV's lane before it comes.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }
{ include("shared/reckoning.asl") }

assertion(collision_avoidance).  // its id in the scenario's file of assertions

!exercise_av.

+!exercise_av : assertion(Id) <- !set_out; !exercise(Id).

+!exercise(collision_avoidance) : meets_av_in(_) <- !cross_road.
+!exercise(avoidability) : stands_in_time        <- !stand_in_its_way.
+!exercise(recovery) : crosses_before            <- !cross_road.
+!exercise(Id)                                   <- !walk; !exercise(Id).

// The pedestrian reaches the AV's rows when the AV is 2 s to 4 s away: time enough to brake.
stands_in_time :-
  at(_, Y) & av_rows(First, Last) & seconds_to_rows(First, Last, S) & av_in(S + 2, From) &
  av_in(S + 4, To) & Y >= From & Y <= To.

// Out of the AV's lane again before the AV comes.
crosses_before :-
  at(X, Y) & zone_rows(First, Last) & rows_to(X, First, Last, N) &
  seconds_to_walk(N + Last - First + 1, S) & av_in(S, AvY) & Y > AvY.

+!stand_in_its_way : at(X, _) & av_rows(First, Last) & First <= X & X <= Last
  <- stay;
     !stand_in_its_way.
+!stand_in_its_way : towards_its_way(Way) & across(Way, Step) <- move(Step); !stand_in_its_way.
+!stand_in_its_way.

towards_its_way(right) :- at(X, _) & av_rows(First, _) & X < First.
towards_its_way(left)  :- at(X, _) & av_rows(_, Last) & X > Last.
