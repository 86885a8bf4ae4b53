// X[A] takes the literal without annotations.
!start.
+!start <- X[A] = p(1)[q]; .print(X, " ", A); Y = g(2)[a]; Z = Y[b]; .print(Z).
// expect: p(1) q
// expect: g(2)[a,b]
