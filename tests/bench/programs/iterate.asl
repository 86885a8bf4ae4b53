// Rounds of a loop over numbers.
n(100).
!start.
+!start : n(N) <- for (.range(I, 1, N)) { _X = I }.
