// .relevant_plans: those whose trigger unifies, whatever their context; [] if there are none.
!start.
@a +!g(1) : false <- .print(1).
@b +!g(_) <- .print(2).
@c +!h <- .print(3).
@d +b(_) <- .print(4).
+!start
  <- .relevant_plans({ +!g(1) }, P, L); .length(P, N); .findall(F, .member(M, L) & M =.. [_, F, _, _], Names); .print(N, Names);
     .relevant_plans({ +!g(2) }, Q); .length(Q, K); .print(K); .relevant_plans({ +!none }, E, EL); .print(E, EL);
     .relevant_plans({ +b(7) }, B); .length(B, J); .print(J); !failure.
+!failure <- .relevant_plans({ +!g(1) }, []); .print("never").
-!failure[error(E)] <- .print(E).
// expect: 2[a,b]
// expect: 1
// expect: [][]
// expect: 1
// expect: ia_failed
