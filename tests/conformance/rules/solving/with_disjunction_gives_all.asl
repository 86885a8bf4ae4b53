// Both sides of a disjunction answer, the left one first.
a(1). a(2). b(2). b(3).
r(X) :- a(X) | b(X).
!start.
+!start <- .findall(X, r(X), L); .print(L).
// expect: [1,2,2,3]
