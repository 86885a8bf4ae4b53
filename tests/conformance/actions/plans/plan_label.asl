// .plan_label: the plan of a label, the label of a plan.
!start.
@lab[cost(1)] +!g(X) <- .print(X).
+!start
  <- .plan_label(P, lab); P =.. [_, T, _, B]; .print(T); .plan_label(P, L); L =.. [_, F, _, _]; .print(F); !failure.
+!failure <- .plan_label(_, none_such); .print("never").
-!failure[error(E)] <- .print(E).
// expect: +!g(X)
// expect: lab
// expect: ia_failed
