// Goals may call each other in turn.
!even(6).
+!even(0) <- .print("even").
+!even(N) <- !odd(N - 1).
+!odd(0) <- .print("odd").
+!odd(N) <- !even(N - 1).
// expect: even
