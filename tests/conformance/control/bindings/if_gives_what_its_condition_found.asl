// What the condition of an if binds is known in both the branch and after it.
p(1). p(2).
!start.
+!start <- if (p(X) & X > 1) { .print("in ", X) }; .print("after ", X).
// expect: in 2
// expect: after 2
