// jaywalk: allow-file unused-rule
// Nothing is wrong here, or said to be.
size(3).
unused(X) :- size(X).

!go(1).

+!go(N) : size(Most) & N <= Most & not at(N, _)
  <- move(right);
     if (at(X, _) & X > N) { Next = X } else { Next = N + 1 };
     !go(Next).
+!go(N) : size(N) <- .random(R); for (.range(I, 1, 3)) { stay }; .print(R * 2).
+!go(_) <- .print("arrived").
-!go(N)[error(E)] <- .print(N, E).
