// .empty: lists, strings, sets, maps, queues of size 0.
!start.
+!start
  <- .empty([]); .empty(""); .set.create(S); .empty(S); .map.create(M); .empty(M); .queue.create(Q); .empty(Q);
     .print("all empty"); .set.add(S, a);
     if (not .empty(S) & not .empty([a]) & not .empty("a")) { .print("none empty") }; !failure.
+!failure <- .empty([a]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: all empty
// expect: none empty
// expect: ia_failed
