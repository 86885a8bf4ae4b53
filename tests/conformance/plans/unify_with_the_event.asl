// The trigger's arguments must unify.
!go(2, [a, b]).
+!go(1, _) <- .print("one").
+!go(N, [H|_]) : N > 1 <- .print(N, H).
// expect: 2a
