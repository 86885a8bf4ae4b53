// .sublist: parts without gaps, from each start the longest first, [] last.
!start.
+!start
  <- .findall(P, .sublist(P, [a, b, c]), L); .print(L); .findall(P, .sublist(P, []), E); .print(E); .sublist([b, c], [a, b, c, d]); !failure.
+!failure <- .sublist([a, c], [a, b, c]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [[a,b,c],[a,b],[a],[b,c],[b],[c],[]]
// expect: [[]]
// expect: ia_failed
