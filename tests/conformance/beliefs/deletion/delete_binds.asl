// Deleting a pattern deletes the first belief that unifies and binds its variables.
b(1, x). b(2, y).
!start.
+!start <- -b(N, A); .print(N, A); .count(b(_, _), M); .print(M).
// expect: 1x
// expect: 1
