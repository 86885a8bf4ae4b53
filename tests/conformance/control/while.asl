// A while tests its condition before each round.
n(0).
!start.
+!start <- while (n(X) & X < 3) { .print(X); -+n(X + 1) }; ?n(Y); .print("end ", Y).
// expect: 0
// expect: 1
// expect: 2
// expect: end 3
