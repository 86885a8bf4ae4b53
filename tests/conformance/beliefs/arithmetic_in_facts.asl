// Arithmetic in an initial belief is evaluated when it is added.
b(2 * 3 + 1).
!start.
+!start <- ?b(7); .print("seven").
// expect: seven
