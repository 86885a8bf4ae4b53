// A rule that calls itself for ever ends the step, not the agent.
// limit inferences 10000
p(X) :- p(f(X)).
!start.
!other.
+!start <- ?p(0); .print("never").
-!start[error(E)] <- .print("failed").
+!other <- .print("other").
// expect: other
// expect: failed
