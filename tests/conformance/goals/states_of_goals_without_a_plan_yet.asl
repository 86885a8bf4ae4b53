// Goals that are still events are suspended and achieved, too.
!start.
+!start <- !!a; .suspend(a); .wait(10); !!b; .succeed_goal(b).
+!a <- .print("never").
+!b <- .print("never").
^!b[state(S)] <- .print(b, " ", S).
^!a[state(S)] <- .print(a, " ", S).
// expect: a pending
// expect: a suspended
// expect: b pending
// expect: b achieved
// expect: b finished
