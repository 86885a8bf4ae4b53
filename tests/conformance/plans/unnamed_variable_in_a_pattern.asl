// In a pattern, the goal's unnamed variable is one variable throughout each plan.
{ begin dg(at(_)) }
+!at(X) : X > 5 <- .print("go to ",X); +at(X).
{ end }
{ begin mg(near(_)) }
+!near(X) <- .print("near").
{ end }
at(3).
!start.
+!start <- !at(3); .print(there); !at(7); .print(done).
// expect: there
// expect: go to 7
// expect: done
