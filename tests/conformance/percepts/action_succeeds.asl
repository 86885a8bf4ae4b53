// An action suspends the intention until the environment has executed it.
// environment: board
!start. !other.
+!start <- .print("before"); move(5); ?at(X); .print("after ", X).
+!other <- .print("other").
// expect: before
// expect: other
// expect: after 5
