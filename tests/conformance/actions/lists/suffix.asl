// .suffix: ends, the longest first, [] last.
!start.
+!start
  <- .findall(P, .suffix(P, [a, b]), L); .print(L); .findall(P, .suffix(P, []), E); .print(E); .suffix([b], [a, b]); .findall(P, .suffix(P, "ab"), S); .print(S); !failure.
+!failure <- .suffix([a], [a, b]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [[a,b],[b],[]]
// expect: [[]]
// expect: ["ab","b",""]
// expect: ia_failed
