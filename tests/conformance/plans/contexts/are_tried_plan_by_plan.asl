// The first plan whose context holds is chosen, in the order of the program.
p(5).
!size(5). !size(50). !size(500).
+!size(X) : X > 100 <- .print(X, " is large").
+!size(X) : p(X) & X > 1 <- .print(X, " is known").
+!size(X) <- .print(X, " is anything").
// expect: 5 is known
// expect: 50 is anything
// expect: 500 is large
