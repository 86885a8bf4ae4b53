// Each clause but the last lacks its full stop.
at_home(1)
distance(X) :- at(X, _)

!start

@first[atomic]
+!start : at(X, Y) <- move(left); stay
+!start <- stay
-!start <- .print("lost").
