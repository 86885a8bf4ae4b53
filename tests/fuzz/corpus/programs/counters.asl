// Loops, arithmetic, replacing beliefs, tail recursion.
n(0). limit(5).
!count. !down(10). !sum([1, 2.5, -3], 0, S).
+!count : n(X) & limit(L) & X < L <- -+n(X + 1); !!count.
+!count <- .abolish(n(_)); +n(0)[k, m(1)]; ?n(Y)[m(Z) | T]; .print(Y, Z, T).
+!down(0).
+!down(N) <- while (n(X) & X > N) { -+n(X - 1) }; !down(N - 1).
+!sum([], A, A) <- .print(A).
+!sum([H | T], A, S) <- !sum(T, A + H mod 2 ** 2, S).
+n(X) : X div 2 * 2 == X <- .print("even ", X).
-n(X)[source(self)] <- ++gone(X).
