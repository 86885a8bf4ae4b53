// Strong negation, lists, sub-goals that return, atomic plans, meta events, sub-plans.
at(r1, 0). ~safe(3). path([1, 2, 3, 4]).
near(A, B) :- at(A, X) & at(B, Y) & math.abs(X - Y) <= 1.
free(P) :- not at(_, P) & not ~safe(P).
!walk.
@w[atomic] +!walk : path(L) <- for (.member(P, L) & free(P)) { !step(P, R); .print(P, R) }; !count(N); .print(N).
+!step(P, ok) : at(r1, X) & P - X <= 2 <- -at(r1, X); +at(r1, P)[time(P)].
+!step(P, far(D)) <- ?at(r1, X); D = P - X.
+!count(N) <- .count(at(_, _)[time(_)], N).
-!walk[error(E)|T] <- .print(E, T).
^!step(P, _)[state(S)] <- ++seen(P, S).
+!job(X) <: done(X) <- !part(1); .wait({+done(X)}, 10). { +!part(N) <- .print(X, N); +done(X). }
!job(4).
