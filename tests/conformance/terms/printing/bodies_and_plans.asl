// Programs as terms are printed within braces.
!start.
+!start
  <- X = { !g; ?t(Y); +a; -b; .print(1); act(2); -+c; !!h; Y = 1 }; .print(X); E = {}; .print(E);
     P = { +!g(Z) : c(Z) <- b1; b2(Z) }; .print(P); T = { +!g }; .print(T); R = { h(W) :- b(W) & c }; .print(R).
// expect: { !g; ?t(Y); +a; -b; .print(1); act(2); -+c; !!h; (Y = 1) }
// expect: { }
// expect: { +!g(Z) : c(Z) <- b1; b2(Z) }
// expect: { +!g }
// expect: { h(W) :- (b(W) & c) }
