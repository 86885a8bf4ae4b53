// What each action on lists does ordinarily, at the boundary, and when it fails.
!start.
+!start
  <- for (.member(A, [".member", ".length", ".empty", ".nth", ".reverse", ".sort", ".shuffle", ".max", ".min",
                      ".union", ".intersection", ".difference", ".range", ".prefix", ".suffix", ".sublist"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".member") <- .findall(X, .member(X, [a, 1, "s"]), L); .print(L).
+!boundary(".member") <- .findall(X, .member(X, []), L); .member(Y, [[]]); .print(L, Y).
+!failure(".member") <- .member(f(2), [f(1), f]).
+!ordinary(".length") <- .length([a, [b, c]], N); .print(N).
+!boundary(".length") <- .length([], N); .length("", M); .length([a|_], K); .print(N, M, K).
+!failure(".length") <- .length(f(1, 2), _).
+!ordinary(".empty") <- if (not .empty([a]) & .empty([])) { .print("empty") }.
+!boundary(".empty") <- if (.empty("") & not .empty(" ") & not .empty([[]])) { .print("a blank counts") }.
+!failure(".empty") <- .empty("a").
+!ordinary(".nth") <- .nth(1, [a, b, c], X); .nth(0, "xyz", C); .print(X, C).
+!boundary(".nth") <- .nth(2, [a, b, c], X); .findall(I, .nth(I, [], _), L); .print(X, L).
+!failure(".nth") <- .nth(3, [a, b, c], _).
+!ordinary(".reverse") <- .reverse([a, b, [c, d]], L); .reverse("abc", S); .print(L, S).
+!boundary(".reverse") <- .reverse([], L); .reverse([a], M); .print(L, M).
+!failure(".reverse") <- .reverse([a, b], [a, b]).
+!ordinary(".sort") <- .sort([c, a, b], L); .print(L).
+!boundary(".sort") <- .sort([], L); .sort([f(1, 1), f(2), 2, a, "a", [1], 1], M); .print(L, M).
+!failure(".sort") <- .sort(a, _).
+!ordinary(".shuffle") <- .shuffle([c, a, b], L); .sort(L, S); .print(S).
+!boundary(".shuffle") <- .shuffle([], L); .shuffle([x], M); .print(L, M).
+!failure(".shuffle") <- .shuffle(a, _).
+!ordinary(".max") <- .max([1, 3, 2], X); .max(Y, .member(Y, [b, c, a]), Z); .print(X, Z).
+!boundary(".max") <- .max([1, a, "z", [9]], X); .max([f(1), f(0, 9)], Y); .print(X, Y).
+!failure(".max") <- .max([], _).
+!ordinary(".min") <- .min([2, 1, 3], X); .min(Y, .member(Y, [b, a, c]), Z); .print(X, Z).
+!boundary(".min") <- .min([a, "z", [9], 1], X); .min([f(1), f(0, 9)], Y); .print(X, Y).
+!failure(".min") <- .min(X, .member(X, []), _).
+!ordinary(".union") <- .union([c, a], [b, a], L); .print(L).
+!boundary(".union") <- .union([], [], L); .union([], [b, a, b], M); .print(L, M).
+!failure(".union") <- .union([a], [b], [b, a]).
+!ordinary(".intersection") <- .intersection([c, a, b], [b, c, d], L); .print(L).
+!boundary(".intersection") <- .intersection([], [a], L); .intersection([a], [a[k]], M); .print(L, M).
+!failure(".intersection") <- .intersection(a, [a], _).
+!ordinary(".difference") <- .difference([c, a, b], [b], L); .print(L).
+!boundary(".difference") <- .difference([], [a], L); .difference([b, a, b], [], M); .print(L, M).
+!failure(".difference") <- .difference([a], a, _).
+!ordinary(".range") <- .findall(X, .range(X, 1, 3), L); .findall(X, .range(X, 5, 1, -2), M); .print(L, M).
+!boundary(".range") <- .findall(X, .range(X, 2, 2), L); .findall(X, .range(X, 2, 1), M); .range(3, 1, 3); .print(L, M).
+!failure(".range") <- .range(4, 1, 3).
+!ordinary(".prefix") <- .findall(P, .prefix(P, [a, b]), L); .print(L).
+!boundary(".prefix") <- .findall(P, .prefix(P, []), L); .prefix([], [a]); .print(L).
+!failure(".prefix") <- .prefix([b], [a, b]).
+!ordinary(".suffix") <- .findall(P, .suffix(P, [a, b]), L); .print(L).
+!boundary(".suffix") <- .findall(P, .suffix(P, []), L); .suffix([], [a]); .print(L).
+!failure(".suffix") <- .suffix([a], [a, b]).
+!ordinary(".sublist") <- .findall(P, .sublist(P, [a, b]), L); .print(L).
+!boundary(".sublist") <- .findall(P, .sublist(P, []), L); .sublist([], [a]); .print(L).
+!failure(".sublist") <- .sublist([a, c], [a, b, c]).
// expect: [a,1,"s"]
// expect: [][]
// expect: .member ia_failed
// expect: 2
// expect: 001
// expect: .length ia_failed
// expect: empty
// expect: a blank counts
// expect: .empty ia_failed
// expect: bx
// expect: c[]
// expect: .nth internal_action
// expect: [[c,d],b,a]cba
// expect: [][a]
// expect: .reverse ia_failed
// expect: [a,b,c]
// expect: [][1,2,"a",[1],a,f(1,1),f(2)]
// expect: .sort wrong_arguments
// expect: [a,b,c]
// expect: [][x]
// expect: .shuffle wrong_arguments
// expect: 3c
// expect: af(1)
// expect: .max ia_failed
// expect: 1a
// expect: 1f(0,9)
// expect: .min ia_failed
// expect: [a,b,c]
// expect: [][a,b]
// expect: .union ia_failed
// expect: [b,c]
// expect: [][]
// expect: .intersection wrong_arguments
// expect: [a,c]
// expect: [][a,b]
// expect: .difference wrong_arguments
// expect: [1,2,3][5,3,1]
// expect: [2][]
// expect: .range ia_failed
// expect: [[a,b],[a],[]]
// expect: [[]]
// expect: .prefix ia_failed
// expect: [[a,b],[b],[]]
// expect: [[]]
// expect: .suffix ia_failed
// expect: [[a,b],[a],[b],[]]
// expect: [[]]
// expect: .sublist ia_failed
