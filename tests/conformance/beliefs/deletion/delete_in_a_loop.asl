// Each round waits for the belief, deletes it and binds variables of its own.
!ask. !answer(1).
+!ask
  <- for (.member(I, [1, 2, 3])) {
       .wait(ack);
       .print("round ", I);
       -ack[source(S)];
       .print("said ", S)
     }.
+!answer(4).
+!answer(N) <- .wait(20); +ack[source(N)]; !answer(N + 1).
// expect: round 1
// expect: said 1
// expect: round 2
// expect: said 2
// expect: round 3
// expect: said 3
