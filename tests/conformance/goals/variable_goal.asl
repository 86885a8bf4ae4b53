// A variable may stand for a goal.
!start.
+!start <- G = go(3); !G; H = go(4); !H[quick].
+!go(N)[quick] <- .print("quick ", N).
+!go(N) <- .print(N).
// expect: 3
// expect: quick 4
