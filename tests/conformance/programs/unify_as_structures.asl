// Plans, bodies and triggers unify with the structures that they are in Jason.
!start.
+!start
  <- P = {@l[x] +!g(Y) : p(Y) <- .print(Y); !h}; P = plan(L,T,C,B); .print(L," ",T," ",C," ",B);
     plan(L2,_,C2,B2) = {+!g <- a}; .print(L2," ",C2," ",B2);
     {!g(a)[b]} = achieve(G); .print(G);
     {?q(1)} = test(Q); .print(Q);
     {-b; +c} = delBel(D,R); R = addBel(E); .print(D," ",E);
     {.print(x)} = internalAction(I); .print(I);
     {Z > 1} = constraint(F); .print(F);
     {a; b; c} = action(X1,action(X2,action(X3))); .print(X1,X2,X3);
     T4 = {-?q}; T4 = te(O,M); .print(O," ",M);
     {h(1) :- b} = h(K); .print(K);
     {} = none; !no.
+!no : {!g} = achieve(g,_) <- .print("never").
+!no : {!g; !h} = achieve(g) <- .print("never").
+!no : {!g} = achieve(h) <- .print("never").
+!no <- .print(done).
// expect: l[x] +!g(Y) p(Y) .print(Y); !h
// expect: nolabel true a
// expect: g(a)[b]
// expect: q(1)
// expect: b c
// expect: .print(x)
// expect: (Z > 1)
// expect: abc
// expect: -? q
// expect: 1
// expect: done
