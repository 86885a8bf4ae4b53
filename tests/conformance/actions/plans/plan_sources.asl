// Sources of plans: an equal plan from another source is not added again, its source is; a source
// can be taken away, and the plan goes with the last one.
!start.
@a +!g(X) : n(Y) & X < Y <- .print(a, X); ?n(Z); .print(Z).
@b[cost(2)] +!h <- .print(b).
n(5).
+!start
  <- .add_plan({ @a +!g(X) : n(Y) & X < Y <- .print(a, X); ?n(Z); .print(Z) }, bob);
     .add_plan({ +!h <- .print(b) }, tom); .add_plan("+!h <- .print(b).", tom);
     .add_plan({ @b +!h <- .print(b) });
     .relevant_plans({ +!g(_) }, _, LA); .print(LA); .relevant_plans({ +!h }, _, LB); .print(LB);
     .remove_plan(b, nobody); .remove_plan(b); .relevant_plans({ +!h }, _, LC); .print(LC); !h;
     .remove_plan(b); .remove_plan([a, b], tom); !g(1);
     .remove_plan("@a"); !g(2); .remove_plan(a, bob); !gone(g(3)); !gone(h);
     +{ +!k <- .print(k) }; .relevant_plans({ +!k }, [P]); .add_plan(P, sue); -P; !k; .remove_plan(P, sue); !gone(k).
+!gone(G) <- !G; .print("never").
-!gone(G)[error(E)] <- .print(G, " ", E).
// expect: [a[source(bob),source(self),url("file:agent.asl")]]
// expect: [b[cost(2),source(self),source(tom),url("file:agent.asl")]]
// expect: [b[cost(2),source(tom),url("file:agent.asl")]]
// expect: b
// expect: a1
// expect: 5
// expect: a2
// expect: 5
// expect: g(3) no_relevant
// expect: h no_relevant
// expect: k
// expect: k no_relevant
