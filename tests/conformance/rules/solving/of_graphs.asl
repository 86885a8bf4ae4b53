// Recursive rules find all that can be reached.
edge(a, b). edge(b, c). edge(c, d). edge(x, y).
path(A, B) :- edge(A, B).
path(A, B) :- edge(A, C) & path(C, B).
!start.
+!start <- .findall(X, path(a, X), L); .print(L); if (not path(a, y)) { .print("no way to y") }.
// expect: [b,c,d]
// expect: no way to y
