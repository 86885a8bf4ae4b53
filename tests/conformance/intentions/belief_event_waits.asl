// +b waits until the plan for it is done; ++b does not.
!start.
+!start <- +b; .print("after b"); ++c; .print("after c").
+b <- .print("b1"); .print("b2").
+c <- .print("c1"); .print("c2").
// expect: b1
// expect: b2
// expect: after b
// expect: after c
// expect: c1
// expect: c2
