// Plans of a file have it in their label; those that were added do not.
!start.
@here[cost(3)] +!g <- .print(g).
+!start
  <- .relevant_plans({+!g},_,[here[url(U)|_]]); .print(U);
     .relevant_plans({+!g},_,[H]); H =.. [_,F,_,A]; .print(F," ",A);
     .add_plan({@new +!n <- .print(n)}); .relevant_plans({+!n},_,L); .print(L);
     for (.plan_label(P,Q[url("file:agent.asl")])) { Q =.. [_,Name,_,_]; if (Name == here) { .remove_plan(P) } };
     !g.
-!g[error(E)] <- .print(E).
// expect: file:agent.asl
// expect: here [cost(3),source(self),url("file:agent.asl")]
// expect: [new[source(self)]]
// expect: no_relevant
