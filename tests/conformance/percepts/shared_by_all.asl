// All agents perceive the same board.
// environment: board
// agent ann
!start.
+!start <- move(7).
// agent bob
+at(X) <- .print(X).
// expect [bob]: 0
// expect [bob]: 7
