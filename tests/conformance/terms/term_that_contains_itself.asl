// X = f(X) is no failure, and the intention goes on. Such a term is passed on, unified and printed.
!start.
+!start
  <- !t(Z, f(Z)); .print("after ", Z); X = f(X); !use(X); Y = f(f(Y));
     if (X = Y) { .print(equal) }; if (not X = g(_)) { .print(different) };
     V = [a|V]; .print(V); ?b(W, h(1, W)); .print(W); .print(k(X, X)); !believe(X).
+!t(A, A) <- .print("in t").
+!use(T) <- T = f(U); .print(U).
b(A, A).
+!believe(T) <- +c(T); .print("never").
-!believe(_)[error(E)] <- .print(E).
// expect: in t
// expect: after ...f(Z)/Z
// expect: ...f(X)/X
// expect: equal
// expect: different
// expect: ...[a|V]/V
// expect: ...h(1,W)/W
// expect: k(...f(X)/X,...f(X)/X)
// expect: limit
