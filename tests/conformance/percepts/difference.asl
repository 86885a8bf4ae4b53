// What is perceived no more is believed no more.
// environment: board
!start.
+!start <- move(3).
+at(X) <- .print("at ", X).
-at(X) <- .print("not at ", X).
// expect: at 0
// expect: not at 0
// expect: at 3
