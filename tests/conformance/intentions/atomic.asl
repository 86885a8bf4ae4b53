// An atomic plan is not interrupted.
!a. !b.
@first[atomic] +!a <- .print(a1); .print(a2); !sub; .print(a4).
+!sub <- .print(a3).
+!b <- .print(b1).
// expect: a1
// expect: a2
// expect: a3
// expect: a4
// expect: b1
