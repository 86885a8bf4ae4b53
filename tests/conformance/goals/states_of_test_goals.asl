// The event of a test goal is reported as that of an achievement goal, and that its plan is chosen not at all.
!go.
+!go <- ?q(X); .print("done ", X).
+?q(X) <- .print("in q"); X = 1.
^?q(_)[state(S)] <- .print("? ", S).
^!q(_)[state(S)] <- .print("! ", S).
// expect: ! pending
// expect: in q
// expect: done 1
// expect: ? achieved
// expect: ? finished
