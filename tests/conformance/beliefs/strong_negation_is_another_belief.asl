// ~b and b are beliefs of their own.
b(1). ~b(2).
!start.
+!start <- .findall(X, b(X), L); .findall(X, ~b(X), M); .print(L, M); +~b(1); -b(1);
   .findall(X, b(X), L2); .findall(X, ~b(X), M2); .print(L2, M2).
// expect: [1][2]
// expect: [][1,2]
