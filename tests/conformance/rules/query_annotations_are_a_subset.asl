// A query is answered by beliefs with at least its annotations.
b(1)[k]. b(2)[k, m]. b(3).
!start.
+!start <- .findall(X, b(X)[k], L); .findall(X, b(X)[k, m], M); .findall(X, b(X), N); .print(L, M, N).
// expect: [1,2][2][1,2,3]
