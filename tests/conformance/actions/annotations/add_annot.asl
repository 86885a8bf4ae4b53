// .add_annot: a literal, or each of a list, with the annotation; a list is one annotation.
!start.
+!start
  <- .add_annot(a, source(jomi), B); .print(B); .add_annot(a[k], k, C); .print(C); .add_annot([a1, a2], k, L); .print(L);
     .add_annot([], k, E); .print(E); .add_annot(f(1)[z], b(2), F); .print(F); .add_annot(a[k], [b, c], G); .print(G); !failure.
+!failure <- .add_annot(a, k, a); .print("matched").
-!failure[error(E)] <- .print(E).
// expect: a[source(jomi)]
// expect: a[k]
// expect: [a1[k],a2[k]]
// expect: []
// expect: f(1)[b(2),z]
// expect: a[[b,c],k]
// expect: ia_failed
