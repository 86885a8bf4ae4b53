// By functor, positive before negative, then arguments, then how many there are, then annotations.
!start.
+!start
  <- .sort([b, ~a, a, f(2), f(1, 0), f(1), a[k]], L); .print(L).
// expect: [a,a[k],~a,b,f(1),f(1,0),f(2)]
