+!token(0).
+!token(N) : next(A) <- .send(A, achieve, token(N-1)).
