// What can be calculated is, before a plan is looked for.
!start.
+!start <- X = 3; !show(X + 1, [X * 2, f(X - 1)]).
+!show(4, L) <- .print("four ", L).
+!show(_, L) <- .print("never").
// expect: four [6,f(2)]
