// A rule is a term that can be added as a belief.
q(1). q(2).
!start.
+!start <- +{p(X) :- q(X) & X > 1}; .findall(X, p(X), L); .print(L).
// expect: [2]
