!say(1).

+!say(N) : N < 100000 <- .print("line ", N); !say(N + 1).
+!say(_) <- .stopMAS.
