// Sets, maps and queues are handed on, not copied: who changes one changes it for all.
!start.
+!start
  <- .set.create(S); !fill(S); .set.to_list(S, L); .print(L); .set.copy(S, C); .set.add(C, 9);
     .set.to_list(S, M); .print(M); .map.create(K); .map.put(K, s, S); .map.get(K, s, T); .set.clear(T); .length(S, N); .print(N).
+!fill(S) <- .set.add(S, 2); .set.add(S, 1); .set.add(S, 2).
// expect: [1,2]
// expect: [1,2]
// expect: 0
