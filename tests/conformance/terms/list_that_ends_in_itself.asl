// A list that ends in itself cannot be used.
!start.
+!start <- L = [a|L]; .print(L).
-!start <- .print("given up").
// expect: given up
