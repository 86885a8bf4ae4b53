// What each action on strings does ordinarily, at the boundary, and when it fails.
!start.
+!start
  <- for (.member(A, [".concat", ".delete", ".substring", ".replace", ".lower_case", ".upper_case", ".term2string"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".concat") <- .concat("a", 1, b, S); .concat([a], [b, c], L); .print(S, L).
+!boundary(".concat") <- .concat("", "", S); .length(S, N); .concat([], [], L); .concat("x", [a], M); .print(N, L, M).
+!failure(".concat") <- .concat([a], b, _).
+!ordinary(".delete") <- .delete(b, [a, b, c, b], L); .delete("b", "abcb", S); .print(L, S).
+!boundary(".delete") <- .delete(z, [], L); .delete(0, [a], M); .delete(0, 2, [a, b, c], N); .print(L, M, N).
+!failure(".delete") <- .delete(a, [a, b], [a]).
+!ordinary(".substring") <- .substring("b", "abc", P); .substring(S, "abcd", 1, 3); .print(P, S).
+!boundary(".substring") <- .substring("", "abc"); .substring("abc", "abc", P); .substring(S, "abc", 3); .length(S, N); .print(P, N).
+!failure(".substring") <- .substring("abcd", "abc").
+!ordinary(".replace") <- .replace("banana", "an", "AN", S); .print(S).
+!boundary(".replace") <- .replace("", "a", "b", S); .length(S, N); .replace("abc", "", "-", T); .print(N, T).
+!failure(".replace") <- .replace("a", "b", "c", "b").
+!ordinary(".lower_case") <- .lower_case("ABC d", S); .print(S).
+!boundary(".lower_case") <- .lower_case("", S); .length(S, N); .lower_case("1?", T); .print(N, T).
+!failure(".lower_case") <- .lower_case("A", "A").
+!ordinary(".upper_case") <- .upper_case("abc D", S); .print(S).
+!boundary(".upper_case") <- .upper_case("", S); .length(S, N); .upper_case("1?", T); .print(N, T).
+!failure(".upper_case") <- .upper_case("a", "a").
+!ordinary(".term2string") <- .term2string(f(1, "a"), S); .term2string(T, "g(X,[1])"); T =.. [_, F|_]; .print(S, F).
+!boundary(".term2string") <- .term2string("", S); .length(S, N); .term2string(T, "1.50"); .print(N, T).
+!failure(".term2string") <- .term2string(a, "b").
// expect: a1b[a,b,c]
// expect: 0[]x[a]
// expect: .concat wrong_arguments
// expect: [a,c]ac
// expect: [][][c]
// expect: .delete ia_failed
// expect: 1bc
// expect: 00
// expect: .substring ia_failed
// expect: bANANa
// expect: 0-a-b-c-
// expect: .replace ia_failed
// expect: abc d
// expect: 01?
// expect: .lower_case ia_failed
// expect: ABC D
// expect: 01?
// expect: .upper_case ia_failed
// expect: f(1,"a")g
// expect: 21.5
// expect: .term2string ia_failed
