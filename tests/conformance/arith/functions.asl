// Functions are evaluated wherever a term is applied.
!start.
+!start <- .print(math.max(3, 7)); .print(math.abs(-2) + 1); X = math.min(4, 2) * 10; .print(X); .print(f(math.floor(2.7))).
// expect: 7
// expect: 3
// expect: 20
// expect: f(2)
