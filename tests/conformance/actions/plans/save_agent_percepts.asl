// .save_agent: what is only perceived is left out; a belief with another source too is kept with that.
// environment: board
!go.
+!go <- show(p); +p; .print("now"); show(q); .save_agent("copy.asl", [tell]); .create_agent(copy, "copy.asl").
+!tell : p[source(self)] & not p[source(percept)] & not q <- .print("p alone").
// expect: now
// expect [copy]: p alone
