// Plans for test goals may have contexts.
!start.
+!start <- ?size(big, N); ?size(small, M); .print(N, " ", M).
+?size(S, N) : S == big <- N = 10.
+?size(_, N) <- N = 1.
// expect: 10 1
