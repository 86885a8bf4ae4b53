// Initial beliefs raise events from the last to the first, also across predicates.
b(1). c(2). b(3). d(4). ~b(5). c(6). b(7).
+b(X) <- .print(b(X)).
+c(X) <- .print(c(X)).
+~b(X) <- .print(~b(X)).
!start.
+!start <- .findall(X, b(X), L); .print(L).
// expect: b(7)
// expect: c(6)
// expect: ~b(5)
// expect: b(3)
// expect: c(2)
// expect: b(1)
// expect: [1,3,7]
