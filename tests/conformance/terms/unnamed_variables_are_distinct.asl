// Each _ is a variable of its own, also if it has a name.
!start.
+!start <- f(_X, _X) = f(1, 2); .print("distinct").
// expect: distinct
