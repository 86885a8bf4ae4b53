// A conversation without end stops at the limit.
// limit cycles 2000
// expect end: limit
!go.
+!go <- .send(agent, achieve, go).
