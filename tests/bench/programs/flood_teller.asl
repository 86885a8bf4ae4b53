!start.
+!start : n(N) <- !tell(N).
+!tell(0).
+!tell(N) <- .send(listener, achieve, hear(N)); !tell(N-1).
