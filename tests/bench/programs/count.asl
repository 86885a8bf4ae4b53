// A goal that calls itself last: event, plan, intended means, and again.
n(1000).
!start.
+!start : n(N) <- !count(N).
+!count(0).
+!count(N) : N > 0 <- !count(N-1).
