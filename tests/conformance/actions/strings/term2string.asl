// .term2string: a term's text; a text's term, or an atom if it is none.
!start.
+!start
  <- .term2string(f(X, "a", [1, 2.5]), S); .print(S); .length(S, N); .print(N); .term2string(T, "p(1,Y)[a]"); T =.. [F | _]; .print(T);
     .term2string(U, "10"); V = U + 1; .print(V); .term2string(b, "b"); .term2string(A, "3 + * 4"); if (.atom(A)) { .print("an atom") }; !failure.
+!failure <- .term2string(a, "b"); .print("never").
-!failure[error(E)] <- .print(E).
// expect: f(X,"a",[1,2.5])
// expect: 16
// expect: p(1,Y)[a]
// expect: 11
// expect: an atom
// expect: ia_failed
