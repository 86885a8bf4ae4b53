// A belief about a set sees what becomes of the set.
!start.
+!start <- .set.create(S); +bag(S); .set.add(S, x); ?bag(B); .set.to_list(B, L); .print(L).
// expect: [x]
