{ begin namespace(lib, local) }
secret(1).
+!ask(X) <- ?secret(X); default::note(X) = Y; +Y.
{ end }
{ begin ebdg(tidy(R)) }
+!tidy(R) : dirty(R) <- -dirty(R).
+!tidy(R) <- +clean(R).
{ end }
{ begin smc(search(X), stop) }
+!search(X) <- .wait(5); +found.
{ end }
dirty(hall).
!tidy(hall). !search(key). !go.
+!go <- lib::secret(Z); .wait(2); +stop.
-!go <- this_ns::x = W; N::V = lib::secret(1); .print(N, V, W).
+found <- .succeed_goal(search(_)).
