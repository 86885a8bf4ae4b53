// .add_nested_source: earlier sources are nested in the new one.
!start.
+!start
  <- .add_nested_source(a, bob, R); .print(R); .add_nested_source(a[source(bob)], jomi, S); .print(S);
     .add_nested_source([a1, a2[source(x)]], y, L); .print(L); .add_nested_source(a[k, source(b)], c, K); .print(K); !failure.
+!failure <- .add_nested_source(a, bob, a); .print("never").
-!failure[error(E)] <- .print(E).
// expect: a[source(bob)]
// expect: a[source(jomi)[source(bob)]]
// expect: [a1[source(y)],a2[source(y)[source(x)]]]
// expect: a[k,source(c)[source(b)]]
// expect: ia_failed
