// In the context of a plan, the goal that the plan is looked for is desired, but not intended yet.
!start.
+!start <- !g; !!g; !h; !k(1); !!k(2); +b; !!d2; !d2.
+!g : .desire(g) <- .print(desired); .count(.desire(g),N); .print(N).
+!g <- .print(not_desired).
+!h : .intend(h) <- .print(intended).
+!h <- .print(not_intended).
+!k(X) : .desire(k(Y)) <- .print(X," ",Y).
+!k(X) <- .print(none).
+b : .desire(start) <- .print(b_start).
+b <- .print(b_not).
+!d2 : .desire(d2,I) <- .print(d2).
+!d2 <- .print(not_d2).
// expect: desired
// expect: 1
// expect: desired
// expect: not_intended
// expect: 1
// expect: 1 1
// expect: 2 2
// expect: b_start
// expect: d2
// expect: d2
