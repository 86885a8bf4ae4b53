// div cuts towards zero, mod has the sign of the first number.
!start.
+!start
  <- .print(7 div 2, " ", -7 div 2, " ", 7 div -2); .print(7 mod 3, " ", -7 mod 3, " ", 7 mod -3); .print(7.9 div 2, " ", 5.5 mod 2).
// expect: 3 -3 -3
// expect: 1 -1 1
// expect: 3 1.5
