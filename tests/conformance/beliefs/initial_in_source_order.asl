// Initial beliefs are asked in source order.
b(1). b(2). b(3).
!start.
+!start <- .findall(X, b(X), L); .print(L).
// expect: [1,2,3]
