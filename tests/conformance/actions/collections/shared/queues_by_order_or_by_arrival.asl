// A queue gives what came first, one with priority what is least; .queue.head leaves it there.
!start.
+!start
  <- .queue.create(Q); .queue.add_all(Q, [3, 1, 2]); .queue.head(Q, H); .queue.remove(Q, R); .print(H, R); .queue.to_list(Q, L); .print(L);
     .queue.create(P, priority); .queue.add_all(P, [3, 1, 2]); .queue.remove(P, A); .queue.remove(P, B); .queue.remove(P, C); .print(A, B, C);
     !empty(P).
+!empty(P) <- .queue.remove(P, _); .print("never").
-!empty(_)[error(E)] <- .print(E).
// expect: 33
// expect: [1,2]
// expect: 123
// expect: ia_failed
