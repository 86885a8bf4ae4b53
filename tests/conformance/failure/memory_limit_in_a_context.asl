// A context that reaches the memory limit does not hold, and the goal fails like any other.
// limit heap 4000000
p(L) :- p([1|L]).
!start.
+!start <- !m; !n; !o(X); .print(X); +b; ?t; for (.range(I,1,2)) { !m }; !a; .print(end).
+!m : p([]) <- .print(never).
-!m[error(E)] <- .print("fail_m ", E).
+!n : p([]) <- .print(never).
+!n <- .print(second).
+!o(X) : p([]) <- .print(never).
-!o(X) <- X = default.
+b : p([]) <- .print(never).
+?t : p([]) <- .print(never).
-?t <- .print("fail_t").
@q[atomic] +!a <- !m; ?p([]).
-!a <- .print("fail_a").
// expect log: the agent's memory limit is reached
// expect: fail_m no_applicable
// expect: second
// expect: default
// expect: fail_t
// expect: fail_m no_applicable
// expect: fail_m no_applicable
// expect: fail_m no_applicable
// expect: fail_a
// expect: end
