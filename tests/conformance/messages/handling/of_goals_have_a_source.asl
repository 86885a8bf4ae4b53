// A goal that was asked for by another agent has that agent as its source.
// agent bob
+!help(X)[source(S)] <- .print("helps ", S, " with ", X); .send(S, tell, done(X)).
// agent ann
!start.
+!start <- .send(bob, achieve, help(2 + 3)).
+done(X)[source(S)] <- .print(S, " did ", X).
// expect [bob]: helps ann with 5
// expect [ann]: bob did 5
