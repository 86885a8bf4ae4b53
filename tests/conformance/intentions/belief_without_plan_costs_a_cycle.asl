// Adding a belief without a plan lets the others go on meanwhile.
!a. !b.
+!a <- +x; .print(a1); +y; .print(a2).
+!b <- .print(b1); .print(b2); .print(b3).
// expect: b1
// expect: b2
// expect: a1
// expect: b3
// expect: a2
