// When the atomic plan is done its caller makes one more step, then it is an ordinary intention again.
!a. !b.
+!a <- !quick; .print(a3); .print(a4); .print(a5).
@q[atomic] +!quick <- .print(a1); .print(a2).
+!b <- .print(b1); .print(b2).
// expect: b1
// expect: a1
// expect: a2
// expect: a3
// expect: b2
// expect: a4
// expect: a5
