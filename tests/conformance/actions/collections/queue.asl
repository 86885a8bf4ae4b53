// Queues: first in, first out, or the least first; an empty one has no head.
!start.
+!start
  <- .queue.create(Q); .queue.add(Q, 3); .queue.add(Q, 1); .queue.add_all(Q, [2, 3]); .queue.to_list(Q, L); .print(L);
     .queue.head(Q, H); .queue.remove(Q, R); .print(H, R); .queue.to_list(Q, L2); .print(L2); .queue.copy(Q, C); .queue.clear(Q);
     .queue.to_list(Q, E); .queue.to_list(C, F); .print(E, F);
     .queue.create(P, priority); .queue.add_all(P, [3, 1, 2]); .queue.remove(P, A); .queue.remove(P, B); .queue.head(P, D); .print(A, B, D); !head; !remove.
+!head <- .queue.create(Q); .queue.head(Q, _); .print("never").
-!head[error(E)] <- .print(E).
+!remove <- .queue.create(Q, priority); .queue.remove(Q, _); .print("never").
-!remove[error(E)] <- .print(E).
// expect: [3,1,2,3]
// expect: 33
// expect: [1,2,3]
// expect: [][1,2,3]
// expect: 123
// expect: ia_failed
// expect: ia_failed
