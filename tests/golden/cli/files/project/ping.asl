!start.

+!start <- .send(listener1, tell, ball(1)).

+back(N)[source(Who)] <- .print(Who, " sent back ", N).
