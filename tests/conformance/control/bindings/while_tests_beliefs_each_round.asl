// The condition of a while is looked at before each round.
n(3).
!start.
+!start <- while (n(X) & X > 0) { .print(X); -+n(X - 1) }; ?n(Last); .print("ends at ", Last).
// expect: 3
// expect: 2
// expect: 1
// expect: ends at 0
