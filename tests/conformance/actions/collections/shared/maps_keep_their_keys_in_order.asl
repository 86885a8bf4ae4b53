// Keys come in the order of terms, values in that of their keys; a second put replaces the first.
!start.
+!start
  <- .map.create(M); .map.put(M, b, 2); .map.put(M, "a", 1); .map.put(M, 7, 0); .map.put(M, b, 3);
     .findall(K, .map.key(M, K), Ks); .print(Ks); .findall(V, .map.value(M, V), Vs); .print(Vs); .length(M, N); .print(N).
// expect: [7,"a",b]
// expect: [0,1,3]
// expect: 3
