// What each query does ordinarily, at the boundary, and when it fails.
b(2). b(1). b(2, x).
!start.
+!start
  <- for (.member(A, [".findall", ".setof", ".count", ".eval"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".findall") <- .findall(f(X), b(X), L); .print(L).
+!boundary(".findall") <- .findall(X, none(X), L); .findall(x, b(_), M); .findall(Y, true, N); .length(N, K); .print(L, M, K).
+!failure(".findall") <- .findall(X, b(X), [1, 2]).
+!ordinary(".setof") <- .setof(X, b(X) | b(X, _), L); .print(L).
+!boundary(".setof") <- .setof(X, none(X), L); .setof(x, b(_), M); .print(L, M).
+!failure(".setof") <- .setof(X, b(X), [2, 1]).
+!ordinary(".count") <- .count(b(_), N); M = .count(b(X) & X > 1); .print(N, M).
+!boundary(".count") <- .count(none(_), N); .count(true, M); .count(b(_), 2); .print(N, M).
+!failure(".count") <- .count(b(_), 3).
+!ordinary(".eval") <- .eval(T, b(X) & X < 2); .print(T).
+!boundary(".eval") <- .eval(T, none(_)); .eval(F, not none(_) & (b(9) | true)); .print(T, F).
+!failure(".eval") <- .eval(true, false).
// expect: [f(2),f(1)]
// expect: [][x,x]1
// expect: .findall ia_failed
// expect: [1,2]
// expect: [][x]
// expect: .setof ia_failed
// expect: 21
// expect: 01
// expect: .count ia_failed
// expect: true
// expect: falsetrue
// expect: .eval ia_failed
