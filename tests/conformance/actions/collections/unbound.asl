// Sets and maps that have no value yet are made by whatever action asks for them; a copy may be compared.
!start.
+!start
  <- .set.to_list(A, L); .print(A, L); .set.clear(B); .set.remove(C, a); .set.intersection(D, [a]); .set.difference(E, [a]); .print(B, C, D, E);
     .set.copy(F, G); .print(F, G); .set.add(H, a); .set.copy(H, H); .map.get(M, k, V, 7); .print(M, V);
     .map.clear(N); .map.copy(O, P); .print(N, O, P); .map.copy(O, N); !set; !map; !key; !queue.
+!set <- .set.add(S, a); .set.add(T, b); .set.copy(S, T); .print(never).
-!set[error(E)] <- .print(E).
+!map <- .map.get(_, k, _); .print(never).
-!map[error(E)] <- .print(E).
+!key <- .map.key(_, _); .print(never).
-!key[error(E)] <- .print(E).
+!queue <- .queue.create(Q); .queue.add(Q, a); .queue.copy(Q, Q); .print(never).
-!queue[error(E)] <- .print(E).
// expect: {}[]
// expect: {}{}{}{}
// expect: {}{}
// expect: {}7
// expect: {}{}{}
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
