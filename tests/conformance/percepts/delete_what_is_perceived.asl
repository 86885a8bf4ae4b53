// A percept that the agent deletes, by whatever annotation, is believed again at the next perception.
// environment: board
!start.
+!start
  <- .wait(100); -at(0)[source(S)]; .print(S);
     .wait(100); move(1).
+at(X)[source(S)] <- .print("at ", X, " by ", S).
-at(X)[source(S)] <- .print("not at ", X, " by ", S).
// expect: at 0 by percept
// expect: not at 0 by percept
// expect: percept
// expect: at 0 by percept
// expect: not at 0 by percept
// expect: at 1 by percept
