// Sub-goals that return a value.
n(10).
!start.
+!start : n(N) <- !fib(N, F); .print(F).
+!fib(0, 1).
+!fib(1, 1).
+!fib(N, F) : N > 1 <- !fib(N-1, A); !fib(N-2, B); F = A+B.
