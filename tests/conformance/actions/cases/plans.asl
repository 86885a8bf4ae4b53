// What each action on plans does ordinarily, at the boundary, and when it fails.
!start.
@a +!g(1) <- .print(a).
@b +!g(X) <- .print(b).
+!start
  <- for (.member(A, [".relevant_plans", ".relevant_plan", ".plan_label", ".list_plans", ".add_plan", ".remove_plan", ".include", ".save_agent"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".add_plan") <- .add_plan({ +!new <- .print("added") }); !new.
+!boundary(".add_plan") <- .add_plan([]); .add_plan("+!new <- .print(\"first\").", self, begin); !new.
+!failure(".add_plan") <- .add_plan({ @b +!other }).
+!ordinary(".remove_plan") <- .remove_plan(a); !g(1).
+!boundary(".remove_plan") <- .remove_plan(none); .remove_plan([]); .remove_plan(b, nobody); !g(1).
+!failure(".remove_plan") <- .remove_plan.
+!ordinary(".plan_label") <- .plan_label(P, a); .plan_label(P, L); .print(P).
+!boundary(".plan_label") <- .plan_label({ @X +!g(1) <- _ }, a); .print("a pattern").
+!failure(".plan_label") <- .plan_label(_, none).
+!ordinary(".relevant_plans") <- .relevant_plans({ +!g(1) }, P, L); .length(P, N); .print(N, L).
+!boundary(".relevant_plans") <- .relevant_plans({ +!none }, P, L); .print(P, L).
+!failure(".relevant_plans") <- .relevant_plans({ +!g(1) }, []).
+!ordinary(".relevant_plan") <- .findall(P, .relevant_plan({ +!g(1) }, P), L); .length(L, N); .print(N).
+!boundary(".relevant_plan") <- .findall(P, .relevant_plan({ +!g(2) }, P), L); .length(L, N); .print(N).
+!failure(".relevant_plan") <- .relevant_plan({ +!none }, _).
+!ordinary(".list_plans") <- .list_plans({ +!g(1) }).
+!boundary(".list_plans") <- .list_plans({ +!none }); .print("none").
+!failure(".list_plans") <- if (not .list_plans({ +!g(2) })) { .print("bad") }.
+!ordinary(".include") <- .include("colours.asl"); ?colour(X); .print(X).
+!boundary(".include") <- .include("colours.asl", N); ?N::colour(X); .print(X).
+!failure(".include") <- .include("missing.asl"); .print("goes on").
+!ordinary(".save_agent") <- .save_agent("copy.asl"); .print("saved").
+!boundary(".save_agent") <- .save_agent("copy.asl", []); .save_agent("copy.asl", [g(1)]); .print("saved").
+!failure(".save_agent") <- .save_agent.
// expect log: missing.asl: no such file
// expect: 2[a[source(self),url("file:agent.asl")],b[source(self),url("file:agent.asl")]]
// expect: [][]
// expect: .relevant_plans ia_failed
// expect: 2
// expect: 1
// expect: .relevant_plan ia_failed
// expect: { @a[source(self),url("file:agent.asl")] +!g(1) <- .print(a) }
// expect: a pattern
// expect: .plan_label ia_failed
// expect: @a[source(self),url("file:agent.asl")] +!g(1) <- .print(a).
// expect: @b[source(self),url("file:agent.asl")] +!g(X) <- .print(b).
// expect: none
// expect: @b[source(self),url("file:agent.asl")] +!g(X) <- .print(b).
// expect: added
// expect: first
// expect: .add_plan internal_action
// expect: b
// expect: b
// expect: .remove_plan wrong_arguments
// expect: red
// expect: red
// expect: goes on
// expect: saved
// expect: saved
// expect: .save_agent wrong_arguments
// file colours.asl
colour(red).
