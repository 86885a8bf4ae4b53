// What each action on beliefs, rules and namespaces does ordinarily, at the boundary, and when it fails.
b(1). b(2)[source(bob)]. c(1).
r(X) :- b(X) & X > 1.
n::p(1).
!start.
+!start
  <- for (.member(A, [".belief", ".relevant_rules", ".list_rules", ".namespace", ".namespace_set_prop", ".namespace_get_prop",
                      ".asserta", ".assertz", ".abolish", ".perceive"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".abolish") <- .abolish(b(_)); .count(b(_), N); .print(N).
+!boundary(".abolish") <- .abolish(none(_)); .abolish(r(_)); .abolish(c(2)); .count(c(_), N); .relevant_rules(r(_), L); .length(L, K); .print(N, K).
+!failure(".abolish") <- .abolish(3).
+!ordinary(".asserta") <- .asserta(b(0)); .findall(X, b(X), L); .print(L).
+!boundary(".asserta") <- .asserta({ s(X) :- b(X) & X > 1 }); .asserta(b(0)); .findall(X, s(X), L); .count(b(0), N); .print(L, N).
+!failure(".asserta") <- .asserta(3).
+!ordinary(".assertz") <- .assertz(b(9)); .findall(X, b(X), L); .print(L).
+!boundary(".assertz") <- .assertz({ t(X) :- b(X) & X > 2 }); .assertz(b(9)); .findall(X, t(X), L); .count(b(9), N); .print(L, N).
+!failure(".assertz") <- .assertz("b").
+!ordinary(".belief") <- .findall(X, .belief(b(X)), L); .print(L).
+!boundary(".belief") <- .findall(X, .belief(r(X)), L); .findall(X, .belief(b(X)[source(bob)]), M); .print(L, M).
+!failure(".belief") <- .belief(b(7)).
+!ordinary(".relevant_rules") <- .relevant_rules(r(_), L); .length(L, N); .print(N).
+!boundary(".relevant_rules") <- .relevant_rules(b(_), L); .print(L).
+!failure(".relevant_rules") <- .relevant_rules(r(_), []).
+!ordinary(".list_rules") <- .list_rules.
+!boundary(".list_rules") <- -+last(1); .list_rules.
+!failure(".list_rules") <- if (not .list_rules) { .print("bad") }.
+!ordinary(".namespace") <- .namespace(n); .print("n").
+!boundary(".namespace") <- if (.namespace(default) & not .namespace(m)) { .print("default") }.
+!failure(".namespace") <- .namespace(m).
+!ordinary(".namespace_set_prop") <- .namespace_set_prop(n, k, v); .namespace_get_prop(n, k, V); .print(V).
+!boundary(".namespace_set_prop") <- .namespace_set_prop(new, k, v); .namespace_set_prop(new, k, [w]); .namespace_get_prop(new, k, V); .print(V).
+!failure(".namespace_set_prop") <- .namespace_set_prop("n", k, v).
+!ordinary(".namespace_get_prop") <- .namespace_get_prop(n, k, V); .findall(K, .namespace_get_prop(n, K, _), L); .print(V, L).
+!boundary(".namespace_get_prop") <- .namespace_get_prop(n, missing, V, none); .namespace_get_prop(n, missing, W); .print(V, W).
+!failure(".namespace_get_prop") <- .namespace_get_prop(n, k, w).
+!ordinary(".perceive") <- .perceive; .print("looked").
+!boundary(".perceive") <- .perceive; .perceive; .count(c(_), N); .print(N).
+!failure(".perceive") <- if (not .perceive) { .print("bad") } else { .print("never fails") }.
// expect: [1,2]
// expect: [][2]
// expect: .belief ia_failed
// expect: 1
// expect: []
// expect: .relevant_rules ia_failed
// expect: r(X)[source(self)] :- (b(X) & (X > 1))
// expect: r(X)[source(self)] :- (b(X) & (X > 1))
// expect: r(X)[source(self)] :- (b(X) & (X > 1))
// expect: n
// expect: default
// expect: .namespace ia_failed
// expect: v
// expect: [w]
// expect: .namespace_set_prop wrong_arguments
// expect: v[k]
// expect: noneW<no-value>
// expect: .namespace_get_prop ia_failed
// expect: [0,1,2]
// expect: [2]1
// expect: .asserta unknown
// expect: [0,1,2,9]
// expect: [9]1
// expect: .assertz unknown
// expect: 0
// expect: 11
// expect: .abolish wrong_arguments
// expect: looked
// expect: 1
// expect: never fails
