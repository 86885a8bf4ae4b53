// Branches within a loop see what the round has bound.
!start.
+!start <- for (.member(X, [1, 2])) { (.print(a, X)) |&| (.print(b, X)) }; .print(end).
// expect: a1
// expect: b1
// expect: a2
// expect: b2
// expect: end
