// Plans that are the answer to askHow are of the agent that gave them.
// agent ann
!start.
+!start
  <- .send(bob, askHow, {+!cook(_)}, L); .print(L);
     for (.member(P, L)) { .add_plan(P, bob) };
     !cook(rice); .remove_plan(soup, bob); !cook(pasta).
-!cook(X)[error(E)] <- .print(X, " ", E).
// agent bob
@soup +!cook(X) <- .print("cooking ", X).
// expect [ann]: [{ @soup[source(bob),url("file:bob.asl")] +!cook(X) <- .print("cooking ",X) }]
// expect [ann]: cooking rice
// expect [ann]: pasta no_relevant
