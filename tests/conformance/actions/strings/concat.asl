// .concat: lists if the first is one; otherwise texts, quoted atoms without their quotes.
!start.
+!start
  <- .concat([1], [2, 3], [], L); .print(L); .concat([], [], E); .print(E); .concat("a", b, 3, [x], f("y"), S); .print(S);
     .concat('New York', " ", 1.5, T); .print(T); .concat("", "", Z); .length(Z, N); .print(N); .concat("a", "b", "ab"); !failure.
+!failure <- .concat("a", "b", "ba"); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [1,2,3]
// expect: []
// expect: ab3[x]f("y")
// expect: New York 1.5
// expect: 0
// expect: ia_failed
