// What each action on sets, maps and queues does ordinarily, at the boundary, and when it fails.
!start.
+!start
  <- for (.member(A, [".set.create", ".set.add", ".set.add_all", ".set.remove", ".set.union", ".set.intersection",
                      ".set.difference", ".set.to_list", ".set.clear", ".set.copy",
                      ".map.create", ".map.put", ".map.get", ".map.remove", ".map.key", ".map.value", ".map.clear", ".map.copy",
                      ".queue.create", ".queue.add", ".queue.add_all", ".queue.head", ".queue.remove", ".queue.to_list",
                      ".queue.clear", ".queue.copy"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".set.create") <- .set.create(S); .print(S).
+!boundary(".set.create") <- .set.create(S); .set.create(T); .set.add(S, a); .print(S, T).
+!failure(".set.create") <- .set.create(a).
+!ordinary(".set.add") <- .set.create(S); .set.add(S, b); .set.add(S, a); .print(S).
+!boundary(".set.add") <- .set.add(S, a); .set.add(S, a); .set.add(S, []); .print(S).
+!failure(".set.add") <- .set.add(a, b).
+!ordinary(".set.add_all") <- .set.create(S); .set.add_all(S, [b, a, b]); .print(S).
+!boundary(".set.add_all") <- .set.create(S); .set.add_all(S, []); .set.add_all(T, S); .print(S, T).
+!failure(".set.add_all") <- .set.create(S); .set.add_all(S, a).
+!ordinary(".set.remove") <- .set.create(S); .set.add_all(S, [a, b]); .set.remove(S, a); .print(S).
+!boundary(".set.remove") <- .set.create(S); .set.remove(S, a); .print(S).
+!failure(".set.remove") <- .set.remove([a], a).
+!ordinary(".set.union") <- .set.create(S); .set.add(S, b); .set.union(S, [a]); .print(S).
+!boundary(".set.union") <- .set.create(S); .set.union(S, []); .set.union(S, S); .print(S).
+!failure(".set.union") <- .set.create(S); .set.union(S, a).
+!ordinary(".set.intersection") <- .set.create(S); .set.add_all(S, [a, b, c]); .set.intersection(S, [b, c, d]); .print(S).
+!boundary(".set.intersection") <- .set.create(S); .set.add(S, a); .set.intersection(S, []); .print(S).
+!failure(".set.intersection") <- .set.create(S); .set.intersection(S, a).
+!ordinary(".set.difference") <- .set.create(S); .set.add_all(S, [a, b, c]); .set.difference(S, [b]); .print(S).
+!boundary(".set.difference") <- .set.create(S); .set.add(S, a); .set.difference(S, S); .print(S).
+!failure(".set.difference") <- .set.create(S); .set.difference(S, a).
+!ordinary(".set.to_list") <- .set.create(S); .set.add_all(S, [b, "s", 1]); .set.to_list(S, L); .print(L).
+!boundary(".set.to_list") <- .set.create(S); .set.to_list(S, L); .print(L).
+!failure(".set.to_list") <- .set.create(S); .set.to_list(S, [a]).
+!ordinary(".set.clear") <- .set.create(S); .set.add(S, a); .set.clear(S); .print(S).
+!boundary(".set.clear") <- .set.create(S); .set.clear(S); .print(S).
+!failure(".set.clear") <- .set.clear(a).
+!ordinary(".set.copy") <- .set.create(S); .set.add(S, a); .set.copy(S, C); .set.add(S, b); .print(S, C).
+!boundary(".set.copy") <- .set.create(S); .set.copy(S, C); .set.add(C, a); .print(S, C).
+!failure(".set.copy") <- .set.create(S); .set.copy(S, a).

+!ordinary(".map.create") <- .map.create(M); .print(M).
+!boundary(".map.create") <- .map.create(M); .map.create(N); .map.put(M, k, v); .print(M, N).
+!failure(".map.create") <- .map.create(a).
+!ordinary(".map.put") <- .map.create(M); .map.put(M, b, 2); .map.put(M, a, 1); .print(M).
+!boundary(".map.put") <- .map.put(M, k, 1); .map.put(M, k, 2); .map.put(M, "k", []); .print(M).
+!failure(".map.put") <- .map.put(a, k, v).
+!ordinary(".map.get") <- .map.put(M, k, v); .map.get(M, k, V); .print(V).
+!boundary(".map.get") <- .map.create(M); .map.get(M, k, V, none); .print(V).
+!failure(".map.get") <- .map.create(M); .map.get(M, k, _).
+!ordinary(".map.remove") <- .map.put(M, k, v); .map.remove(M, k, V); .print(V, M).
+!boundary(".map.remove") <- .map.put(M, k, v); .map.put(M, l, w); .map.remove(M, k, v); .print(M).
+!failure(".map.remove") <- .map.create(M); .map.remove(M, k, _).
+!ordinary(".map.key") <- .map.put(M, b, 1); .map.put(M, a, 2); .findall(K, .map.key(M, K), L); .print(L).
+!boundary(".map.key") <- .map.create(M); .findall(K, .map.key(M, K), L); .print(L).
+!failure(".map.key") <- .map.put(M, k, v); .map.key(M, l).
+!ordinary(".map.value") <- .map.put(M, b, 1); .map.put(M, a, 2); .findall(V, .map.value(M, V), L); .print(L).
+!boundary(".map.value") <- .map.create(M); .findall(V, .map.value(M, V), L); .print(L).
+!failure(".map.value") <- .map.put(M, k, v); .map.value(M, w).
+!ordinary(".map.clear") <- .map.put(M, k, v); .map.clear(M); .print(M).
+!boundary(".map.clear") <- .map.create(M); .map.clear(M); .print(M).
+!failure(".map.clear") <- .map.clear(a).
+!ordinary(".map.copy") <- .map.put(M, k, v); .map.copy(M, C); .map.put(M, k, w); .print(M, C).
+!boundary(".map.copy") <- .map.create(M); .map.copy(M, C); .map.put(C, k, v); .print(M, C).
+!failure(".map.copy") <- .map.create(M); .map.copy(M, a).

+!ordinary(".queue.create") <- .queue.create(Q); .queue.add_all(Q, [2, 1]); .queue.head(Q, H); .print(H).
+!boundary(".queue.create") <- .queue.create(Q, priority); .queue.add_all(Q, [2, 1]); .queue.head(Q, H); .print(H).
+!failure(".queue.create") <- .queue.create(a).
+!ordinary(".queue.add") <- .queue.create(Q); .queue.add(Q, b); .queue.add(Q, a); .queue.to_list(Q, L); .print(L).
+!boundary(".queue.add") <- .queue.create(Q); .queue.add(Q, a); .queue.add(Q, a); .queue.to_list(Q, L); .print(L).
+!failure(".queue.add") <- .queue.add(a, b).
+!ordinary(".queue.add_all") <- .queue.create(Q); .queue.add_all(Q, [b, a]); .queue.to_list(Q, L); .print(L).
+!boundary(".queue.add_all") <- .queue.create(Q); .queue.add_all(Q, []); .queue.to_list(Q, L); .print(L).
+!failure(".queue.add_all") <- .queue.create(Q); .queue.add_all(Q, a).
+!ordinary(".queue.head") <- .queue.create(Q); .queue.add_all(Q, [b, a]); .queue.head(Q, H); .queue.head(Q, I); .print(H, I).
+!boundary(".queue.head") <- .queue.create(Q); .queue.add(Q, f(1)); .queue.head(Q, f(X)); .print(X).
+!failure(".queue.head") <- .queue.create(Q); .queue.head(Q, _).
+!ordinary(".queue.remove") <- .queue.create(Q); .queue.add_all(Q, [b, a]); .queue.remove(Q, H); .queue.remove(Q, I); .print(H, I).
+!boundary(".queue.remove") <- .queue.create(Q); .queue.add(Q, a); .queue.remove(Q, a); if (.empty(Q)) { .print("empty") }.
+!failure(".queue.remove") <- .queue.create(Q); .queue.remove(Q, _).
+!ordinary(".queue.to_list") <- .queue.create(Q); .queue.add_all(Q, [b, a, b]); .queue.to_list(Q, L); .print(L).
+!boundary(".queue.to_list") <- .queue.create(Q); .queue.to_list(Q, L); .print(L).
+!failure(".queue.to_list") <- .queue.create(Q); .queue.to_list(Q, [a]).
+!ordinary(".queue.clear") <- .queue.create(Q); .queue.add(Q, a); .queue.clear(Q); .queue.to_list(Q, L); .print(L).
+!boundary(".queue.clear") <- .queue.create(Q); .queue.clear(Q); .queue.to_list(Q, L); .print(L).
+!failure(".queue.clear") <- .queue.clear(a).
+!ordinary(".queue.copy") <- .queue.create(Q); .queue.add(Q, a); .queue.copy(Q, C); .queue.add(Q, b); .queue.to_list(C, L); .print(L).
+!boundary(".queue.copy") <- .queue.create(Q, priority); .queue.copy(Q, C); .queue.add_all(C, [2, 1]); .queue.head(C, H); .print(H).
+!failure(".queue.copy") <- .queue.create(Q); .queue.copy(Q, a).
// expect: {}
// expect: {a}{}
// expect: .set.create ia_failed
// expect: {a,b}
// expect: {[],a}
// expect: .set.add unknown
// expect: {a,b}
// expect: {}{}
// expect: .set.add_all unknown
// expect: {b}
// expect: {}
// expect: .set.remove unknown
// expect: {a,b}
// expect: {}
// expect: .set.union unknown
// expect: {b,c}
// expect: {}
// expect: .set.intersection unknown
// expect: {a,c}
// expect: {}
// expect: .set.difference unknown
// expect: [1,"s",b]
// expect: []
// expect: .set.to_list ia_failed
// expect: {}
// expect: {}
// expect: .set.clear unknown
// expect: {a,b}{a}
// expect: {}{a}
// expect: .set.copy ia_failed
// expect: {}
// expect: {k->v}{}
// expect: .map.create ia_failed
// expect: {a->1,b->2}
// expect: {"k"->[],k->2}
// expect: .map.put unknown
// expect: v
// expect: none
// expect: .map.get ia_failed
// expect: v{}
// expect: {l->w}
// expect: .map.remove ia_failed
// expect: [a,b]
// expect: []
// expect: .map.key ia_failed
// expect: [2,1]
// expect: []
// expect: .map.value ia_failed
// expect: {}
// expect: {}
// expect: .map.clear unknown
// expect: {k->w}{k->v}
// expect: {}{k->v}
// expect: .map.copy ia_failed
// expect: 2
// expect: 1
// expect: .queue.create ia_failed
// expect: [b,a]
// expect: [a,a]
// expect: .queue.add unknown
// expect: [b,a]
// expect: []
// expect: .queue.add_all unknown
// expect: bb
// expect: 1
// expect: .queue.head ia_failed
// expect: ba
// expect: empty
// expect: .queue.remove ia_failed
// expect: [b,a,b]
// expect: []
// expect: .queue.to_list ia_failed
// expect: []
// expect: []
// expect: .queue.clear unknown
// expect: [a]
// expect: 1
// expect: .queue.copy ia_failed
