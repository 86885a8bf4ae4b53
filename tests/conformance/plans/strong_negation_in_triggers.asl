// +b and +~b are different events.
!start.
+!start <- +b(1); +~b(2).
+b(X) <- .print("b ", X).
+~b(X) <- .print("not b ", X).
// expect: b 1
// expect: not b 2
