// Percepts come and go.
// environment: board
!start.
+!start <- show(rain); .wait(50); hide(rain).
+rain <- .print("rain").
-rain <- .print("dry").
// expect: rain
// expect: dry
