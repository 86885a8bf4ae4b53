// / divides reals, div truncates, mod has the sign of the dividend.
!start.
+!start <- .print(7 / 2); .print(7 div 2); .print(-7 div 2); .print(7 mod 3); .print(-7 mod 3); .print(7 mod -3).
// expect: 3.5
// expect: 3
// expect: -3
// expect: 1
// expect: -1
// expect: 1
