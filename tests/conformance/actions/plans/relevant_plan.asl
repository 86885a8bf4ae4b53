// .relevant_plan: one after another.
!start.
@a +!g(1) <- .print(1).
@b +!g(_) <- .print(2).
+!start
  <- .findall(F, .relevant_plan({ +!g(1) }, P) & P =.. [L, _, _, _] & L =.. [_, F, _, _], R); .print(R); !failure.
+!failure <- .relevant_plan({ +!none }, _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [a,b]
// expect: ia_failed
