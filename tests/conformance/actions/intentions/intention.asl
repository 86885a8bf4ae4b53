// .intention: each with its state and stack; the current one.
!start.
+!start
  <- !inner(1).
+!inner(_)
  <- .intention(I, S, [im(_, { +!G }, _, _) | Below], current); .length(Below, N); .print(S, " ", N); G =.. [_, F, _, _]; .print(F);
     !!other; .wait(20); .findall(K, .intention(K, _, _), L); .length(L, M); .print(M); !failure.
+!other <- .wait(1000).
+!failure <- .intention(none, _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: running 1
// expect: inner
// expect: 2
// expect: ia_failed
