// .concat joins lists, or texts.
!start.
+!start <- .concat([1], [2, 3], [], L); .print(L); .concat("a", b, 3, S); .print(S).
// expect: [1,2,3]
// expect: ab3
