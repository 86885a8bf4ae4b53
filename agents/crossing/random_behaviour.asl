// Random behaviour: walk along the pavement, and in every tick start to cross the road with the
// same small probability. Once it has started, it crosses to and fro until the test ends.

{ include("shared/steps.asl") }

crossing_probability(1 / 11).  // per tick

!stroll.

+!stroll : .random(R) & crossing_probability(P) & R < P <- !cross_to_and_fro.
+!stroll : not way(_) <- !set_out; !stroll.
+!stroll              <- !walk; !stroll.

+!cross_to_and_fro : way_across(Way) <- !pace(Way).

+!pace(Way) : turning_point(Way, Back) & across(Back, _) <- !pace(Back).
+!pace(Way) : across(Way, Step)                          <- move(Step); !pace(Way).

// The last row, counted from the left, of the pavement beyond the road; or a dead end.
turning_point(left, right) :- at(X, _) & pavement(0, Last) & (X <= Last | not across(left, _)).
turning_point(right, left) :- not across(right, _).
