// .prefix: beginnings, the longest first, [] last.
!start.
+!start
  <- .findall(P, .prefix(P, [a, b]), L); .print(L); .findall(P, .prefix(P, []), E); .print(E); .prefix([a], [a, b]); .prefix([X, Y], [p, q, r]); .print(X, Y);
     .findall(P, .prefix(P, "ab"), S); .print(S); !failure.
+!failure <- .prefix([b], [a, b]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [[a,b],[a],[]]
// expect: [[]]
// expect: pq
// expect: ["ab","a",""]
// expect: ia_failed
