// .structure: structures and lists; no numbers, strings, variables.
!start.
+!start
  <- .structure(f(1)); .structure([1]); .structure(a[b]); .print("structures");
     if (not .structure(3) & not .structure("s") & not .structure(X)) { .print("no structures") }; !failure.
+!failure <- .structure(3); .print("never").
-!failure[error(E)] <- .print(E).
// expect: structures
// expect: no structures
// expect: ia_failed
