// What a plan's head has given to a variable of its goal is a part of the goal that fails, and is not
// returned.
!s(1, _).
+!s(N, X) : N > 0 <- !g(N, X).
+!g(N, 2) : N > 0 <- .fail.
-!g(N, X) <- .print(failed, N, X); X = 1.
-!s(N, X) <- .print(end, N).
// expect: failed12
// expect: end1
