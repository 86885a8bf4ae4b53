// What is perceived is believed, with the source percept.
// environment: board
+at(X)[source(S)] <- .print(X, " ", S).
// expect: 0 percept
