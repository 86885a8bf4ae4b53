// A rule answers with the source self and no other annotation.
p(X) :- q(X).
q(1).
!start.
+!start <- .findall(S, p(1)[source(S)], L); .print(L);
   .count(p(1)[k], N); .print(N).
// expect: [self]
// expect: 0
