// Directed: a pedestrian who is told which of the AV's assertions to go for, and has a desire for
// each that it knows. What it takes to exercise them differs: to be close in front of the AV, to
// stand in its way in good time, to have crossed its lane before it comes.

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

// Between 2 s and 4 s ahead of the AV when the row of its body is reached: time enough to brake.
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
