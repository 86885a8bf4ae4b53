// A variable as namespace that has no value asks all namespaces: the default one first, then the
// others as they came to be; it gets the namespace.
// expect: [at(k,4),at(m,2),at(m,3)]
// expect: [at(default,1),at(k,4),at(m,2),at(m,3)]
// expect: m 3
// expect: default 1
// expect: [default,m]
// expect: 0 left
m::p(2). m::p(3).
k::p(4).
m::q(X) :- m::p(X) & X > 2.
!go.
+!go <- .findall(at(N,X),N::p(X),L); .print(L);
        +p(1); .findall(at(N,X),N::p(X),M); .print(M);
        ?S::q(Q); .print(S," ",Q);
        ?T::p(Y); .print(T," ",Y);
        .findall(N,.belief(N::p(Z)) & Z < 4 & Z \== 3,B); .print(B);
        .abolish(_::p(_)); .count(_::p(_),C); .print(C," left").
