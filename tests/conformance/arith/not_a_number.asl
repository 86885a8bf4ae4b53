// Arithmetic on what is no number gives NaN.
!start.
+!start <- X = a; Y = X + 1; .print(Y).
// expect: NaN
