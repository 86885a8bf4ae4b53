// A quoted atom keeps its quotes.
!start.
+!start <- X = 'ab'; .print(X); .eval(B, X == ab); .print(B).
// expect: 'ab'
// expect: false
