// Properties of a namespace: set, got, gone through; a default for what is missing.
n::p(1).
!start.
+!start
  <- .namespace_set_prop(n, key, value); .namespace_get_prop(n, key, V); .print(V);
     .namespace_set_prop(n, key, other); .namespace_get_prop(n, key, W); .print(W);
     .namespace_get_prop(n, missing, D, default_value); .print(D);
     .namespace_get_prop(n, missing, M); .print(M); if (.namespace_get_prop(n, key, wrong)) { .print("bad") } else { .print("another") }.
// expect: value
// expect: other
// expect: default_value
// expect: M<no-value>
// expect: another
