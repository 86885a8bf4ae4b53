// Numbers are equal by value, however they are written.
!start.
+!start : 1 == 1.0 & 10 = 1e1 & 2 + 2 == 4 & 3 \== 4 & 0.1 + 0.2 > 0.3 & 1 <= 1.0 <- .print("all hold").
// expect: all hold
