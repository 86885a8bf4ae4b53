// ^!g tells what becomes of a goal.
!start.
+!start <- .wait(10).
^!start[state(S)] <- .print(S).
// expect: pending
// expect: executing
// expect: waiting
// expect: executing
// expect: achieved
// expect: finished
