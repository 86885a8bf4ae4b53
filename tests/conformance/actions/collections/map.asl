// Maps: keys in the order of terms; a missing key fails, or has the default.
!start.
+!start
  <- .map.create(M); .map.put(M, b, 2); .map.put(M, a, 1); .map.put(M, b, 3); .print(M); .map.get(M, b, B); .print(B);
     .map.get(M, z, Z, none); .print(Z); .findall(K, .map.key(M, K), Ks); .findall(V, .map.value(M, V), Vs); .print(Ks, Vs);
     .map.copy(M, C); .map.remove(M, a, A); .print(A, M, C); .map.clear(M); .print(M); .findall(K, .map.key(M, K), E); .print(E);
     .map.put(New, "k", [1]); .print(New); .map.key(C, a); .map.value(C, 3); !missing; !removed; !bound.
+!missing <- .map.create(M); .map.get(M, z, _); .print("never").
-!missing[error(E)] <- .print(E).
+!removed <- .map.create(M); .map.remove(M, z, _); .print("never").
-!removed[error(E)] <- .print(E).
+!bound <- .map.create(a); .print("never").
-!bound[error(E)] <- .print(E).
// expect: {a->1,b->3}
// expect: 3
// expect: none
// expect: [a,b][1,3]
// expect: 1{b->3}{a->1,b->3}
// expect: {}
// expect: []
// expect: {"k"->[1]}
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
