// Relational operators compare terms of any kind.
!start.
+!start : 1 < "a" & "a" < [] & [] < a & a < b & f(1, 0) < f(2) & not b < a <- .print("ordered").
// expect: ordered
