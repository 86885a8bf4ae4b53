// Plans and rules that cannot do what they are for.
!go(1).

+!go(N) <- .print(N).
+!go(1) : at(_, _) <- move(left).

-!gone(N) <- .fail(N); .print("never").

@wait[atomic] +grid(_, _) <- .wait(100); stay.

+grdi(_, _) <- stay.

near(X, Y) :- at(X, Z) & near(Z, Y).
far(X) :- at(X, _) & X > 5.
