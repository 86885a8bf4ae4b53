// .my_name and .all_names; the wrong name fails.
// agent ann
!start.
+!start <- .my_name(N); .print(N); .my_name(ann); .all_names(L); .sort(L, S); .print(S); !failure.
+!failure <- .my_name(bob); .print("never").
-!failure[error(E)] <- .print(E).
// agent bob
p.
// expect [ann]: ann
// expect [ann]: [ann,bob]
// expect [ann]: ia_failed
