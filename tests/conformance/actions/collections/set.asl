// Sets: shared by reference, sorted, each element once.
!start.
+!start
  <- .set.create(S); .set.add(S, b); .set.add(S, a); .set.add(S, b); .print(S); .set.add_all(S, [d, c, a]); .set.to_list(S, L); .print(L);
     .set.remove(S, d); .set.remove(S, missing); .print(S); .set.copy(S, C); .set.clear(S); .print(S, C);
     .set.union(C, [x, a]); .print(C); .set.intersection(C, [a, x, y]); .print(C); .set.difference(C, [x]); .print(C);
     .set.create(D); .set.add(D, z); .set.union(C, D); .print(C); .set.add_all(New, [q]); .print(New); .set.to_list(S, E); .print(E); !failure; !bound.
+!failure <- .set.create(S); .set.add(S, a); .set.to_list(S, [b]); .print("never").
-!failure[error(E)] <- .print(E).
+!bound <- S = a; .set.create(S); .print("never").
-!bound[error(E)] <- .print(E).
// expect: {a,b}
// expect: [a,b,c,d]
// expect: {a,b,c}
// expect: {}{a,b,c}
// expect: {a,b,c,x}
// expect: {a,x}
// expect: {a}
// expect: {a,z}
// expect: {q}
// expect: []
// expect: ia_failed
// expect: ia_failed
