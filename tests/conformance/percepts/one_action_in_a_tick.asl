// An agent acts at most once in a tick.
// environment: board
!start.
+!start <- move(1); move(2); ?at(X); .print(X).
+at(X) <- .print("at ", X).
// expect: at 0
// expect: at 1
// expect: at 2
// expect: 2
