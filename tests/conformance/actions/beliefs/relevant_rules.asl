// .relevant_rules lists the rules whose head unifies.
p(X) :- q(X). p(2) :- r. s(X) :- p(X).
!start.
+!start
  <- .relevant_rules(p(_), L); .length(L, N); .relevant_rules(p(3), M); .length(M, K); .print(N, K);
     .relevant_rules(p(2), B); .member({ p(2) :- Body }, B); .print(Body); .relevant_rules(none(_), E); .print(E).
// expect: 21
// expect: q(2)
// expect: []
