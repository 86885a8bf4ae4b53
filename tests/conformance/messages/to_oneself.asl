// A message to oneself comes from self.
!start.
+!start <- .send(agent, tell, hello).
+hello[source(S)] <- .print(S).
// expect: self
