// An agent that asks itself gets its own name as the source; what it tells itself is from self.
p(1).
!go.
+!go
  <- .my_name(Me);
     .send(Me,askOne,p(_),A); .print(A); .send(self,askOne,p(_),B); .print(B);
     .send(Me,askAll,p(_),C); .print(C); .send(Me,askOne,q(3,_),D); .print(D);
     .send(Me,askOne,nope,E); .print(E); .send([self,Me],askOne,p(_),F); .print(F);
     .send(Me,tell,told).
+?q(X,Y) <- Y = X*2.
+told[source(S)] <- .print("told by ",S).
// expect: p(1)[source(agent)]
// expect: p(1)[source(agent)]
// expect: [p(1)[source(agent)]]
// expect: q(3,6)[source(agent)]
// expect: false
// expect: [p(1)[source(agent)],p(1)[source(agent)]]
// expect: told by self
