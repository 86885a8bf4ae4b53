// .max and .min of the solutions of a query, by the order of terms.
age(ann, 31). age(bob, 17). age(cid, 45).
!start.
+!start <- .max(at(A, N), age(N, A), at(_, Old)); .min(at(A2, N2), age(N2, A2), at(_, Young)); .print(Old, " ", Young).
// expect: cid bob
