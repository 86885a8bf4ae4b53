// .printf formats as Java does; numbers are doubles, so %d fails.
!start.
+!start
  <- .printf("%.2f|%5s|%-4s|%s", 1 / 4, "ab", c, f(1)); .printf("100%%"); !failure.
+!failure <- .printf("%d", 1); .print("never").
-!failure <- .print("no integer").
// expect: 0.25|   ab|c   |f(1)
// expect: 100%
// expect: no integer
