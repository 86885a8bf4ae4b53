// A goal's plan runs before the rest of its caller; values come back through the arguments.
!start.
+!start <- .print("before"); !double(4, R); .print("after ", R).
+!double(X, Y) <- .print("within"); Y = X * 2.
// expect: before
// expect: within
// expect: after 8
