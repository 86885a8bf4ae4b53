// A plan's variables have nothing to do with those of the same name in another.
!start.
+!start <- X = 1; !other; .print(X).
+!other <- X = 2; .print(X).
// expect: 2
// expect: 1
