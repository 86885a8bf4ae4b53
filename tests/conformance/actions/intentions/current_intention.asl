// .current_intention: the stack of what is carried out.
!start.
+!start <- !inner; !failure.
+!inner <- .current_intention(intention(_, [im(_, { +!G }, _, _) | Below])); .length(Below, N); G =.. [_, F, _, _]; .print(F, N).
+!failure <- .current_intention(none); .print("never").
-!failure[error(E)] <- .print(E).
// expect: inner1
// expect: ia_failed
