// A query with annotations goes through all that fit.
b(1)[k(1), k(2)].
!start.
+!start <- .findall(X, b(1)[k(X)], L); .print(L).
// expect: [1,2]
