// Random behaviour: walk along the pavement, and in every tick start to cross the road with the
// same small probability. Who has started crosses to and fro until the test ends.

{ include("shared/steps.asl") }

crossing_probability(1 / 11).  // per tick

!stroll.

+!stroll : .random(R) & crossing_probability(P) & R < P <- !cross_to_and_fro.
+!stroll : not way(_) <- !set_out; !stroll.
+!stroll              <- !walk; !stroll.

+!cross_to_and_fro : way_across(Way) <- !pace(Way).

+!pace(Way) : turning_point(Way, Back) <- !pace(Back).
+!pace(Way)                            <- move(Way); !pace(Way).

// The last row, counted from the left, of the pavement beyond the road.
turning_point(left, right) :- at(X, _) & pavement(0, X).
turning_point(right, left) :- at(X, _) & grid(Rows, _) & X == Rows - 1.
