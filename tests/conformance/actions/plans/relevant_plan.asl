// .relevant_plan: one after another, as the event would find it; printed without braces.
!start.
@a +!g(1) <- .print(1).
@b +!g(_) <- .print(2).
@c +!h(X,7) : X > 1 <- .print(X).
+!start
  <- .findall(F, .relevant_plan({ +!g(1) }, P) & P =.. [L, _, _, _] & L =.. [_, F, _, _], R); .print(R);
     .relevant_plan({ +!h(2,Y) }, Q); .print(Y, " ", Q); .plan_label(S, c); .print(S);
     .remove_plan(Q); .add_plan(Q); !h(2,7); !failure.
+!failure <- .relevant_plan({ +!none }, _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [a,b]
// expect: 7 @c[source(self),url("file:agent.asl")] +!h(2,7) : (2 > 1) <- .print(2).
// expect: { @c[source(self),url("file:agent.asl")] +!h(X,7) : (X > 1) <- .print(X) }
// expect: 2
// expect: ia_failed
