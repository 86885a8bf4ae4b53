// / by zero is infinite, mod zero not a number; div by zero fails the step alone.
!start.
!other.
+!start <- .print(1 / 0, " ", -1 / 0, " ", 5 mod 0); X = 1 div 0; .print("never").
-!start <- .print("failed").
+!other <- .print("unharmed").
// expect: Infinity -Infinity NaN
// expect: unharmed
// expect: failed
