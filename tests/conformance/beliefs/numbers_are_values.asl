// 1 and 1.0 are the same number.
b(1).
!start.
+!start <- +b(1.0); .count(b(_), N); .print(N); ?b(2 - 1); .print("found").
// expect: 1
// expect: found
