// Prefixes and suffixes from the longest, sublists by their start.
!start.
+!start
  <- .findall(P, .prefix(P, [a, b]), L); .print(L); .findall(P, .suffix(P, [a, b]), M); .print(M);
     .findall(P, .sublist(P, [a, b]), N); .print(N).
// expect: [[a,b],[a],[]]
// expect: [[a,b],[b],[]]
// expect: [[a,b],[a],[b],[]]
