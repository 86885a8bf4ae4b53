// A pedestrian with a misspelt goal, percept, action and internal action.
!exercise_av.

+!exercise_av : att(X, _) & X < 2 <- mvoe(right); !exercise_avv.
+!exercise_av <- .prnit("crossing"); move(left).
