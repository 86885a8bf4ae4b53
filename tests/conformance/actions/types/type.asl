// .type: all types of a term, in turn.
!start.
+!start
  <- !of(3); !of(a); !of(f(X)); !of("s"); !of([1]); .set.create(S); !of(S); .map.create(M); !of(M); .type(a, atom); .findall(K, .type(Free, K), F); .print(F); !failure.
+!of(T) <- .findall(K, .type(T, K), L); .print(L).
+!failure <- .type(a, number); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [number,ground]
// expect: [atom,literal,ground]
// expect: [literal,structure]
// expect: [string,ground]
// expect: [list,structure,ground]
// expect: [set,ground]
// expect: [map,ground]
// expect: [free]
// expect: ia_failed
