// .remove_source_annot: the sources go, other annotations stay.
!start.
+!start
  <- .remove_source_annot(a[source(bob), k], R); .print(R); .remove_source_annot(a, S); .print(S);
     .remove_source_annot([a[source(x)], b[source(y), source(z)]], L); .print(L); !failure.
+!failure <- .remove_source_annot(a[source(bob)], b); .print("never").
-!failure[error(E)] <- .print(E).
// expect: a[k]
// expect: a
// expect: [a,b]
// expect: ia_failed
