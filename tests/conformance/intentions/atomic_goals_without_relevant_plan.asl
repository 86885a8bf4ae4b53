// A goal of an atomic intention goes through all rules of the cycle one by one: that no plan's trigger
// unifies with it is `no_relevant` there. Elsewhere a plan of that name makes it `no_applicable`.
!go.
+!go <- !a; !b; !c.
@atom[atomic] +!a <- !part(1).
+!b <- !part(1).
@atom2[atomic] +!c <- !part(2).
+!part(2) : false <- true.
-!part(X)[error(E)] <- .print(X, " ", E).
// expect: 1 no_relevant
// expect: 1 no_applicable
// expect: 2 no_applicable
