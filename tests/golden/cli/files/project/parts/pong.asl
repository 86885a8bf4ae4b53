+ball(N)[source(Who)] <- .print("got ", N); .send(Who, tell, back(N)).
