// .length of lists, strings, sets, maps and queues, as an action and as a function.
!start.
+!start
  <- .length([a, [b]], N); .length([], Z); .length("abc", S); .length("", E); .print(N, Z, S, E);
     .set.create(A); .set.add(A, x); .length(A, B); .map.create(M); .length(M, C);
     .queue.create(Q); .queue.add(Q, 1); .queue.add(Q, 1); .length(Q, D); .print(B, C, D);
     F = .length([a, b]) * 2; .print(F, .length("xyz")); !failure(abc); !failure(12); !wrong.
+!failure(X) <- .length(X, _); .print("never").
-!failure(X)[error(E)] <- .print(X, " ", E).
+!wrong <- .length([a], 2); .print("never").
-!wrong[error(E)] <- .print(E).
// expect: 2030
// expect: 102
// expect: 43
// expect: abc ia_failed
// expect: 12 ia_failed
// expect: ia_failed
