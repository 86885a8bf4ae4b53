// Rules are told and untold as beliefs are, but not in lists; as a goal or a signal a rule is its
// head. With plans of its own for messages an agent takes no rule, since a rule is not ground.
// agent bob
!go.
+!go
  <- .send([amy,zoe], tell, p(1)); .send([amy,zoe], tell, p(2)); .send([amy,zoe], tell, {r(X) :- p(X)});
     .send([amy,zoe], achieve, show); .wait(10);
     .send([amy,zoe], tell, [{r2(Y) :- p(Y)}]); .send([amy,zoe], untell, {r(Z) :- q(Z)});
     .send([amy,zoe], achieve, show); .wait(10);
     .send([amy,zoe], tell, {r(4)[source(tom)] :- p(1)}); .send([amy,zoe], untell, {r(4) :- p(1)});
     .send([amy,zoe], achieve, show); .wait(10);
     .send([amy,zoe], achieve, {r(5) :- p(1)}); .send([amy,zoe], signal, {r(6) :- p(1)}).
// agent amy
+!show <- .findall(X, r(X), L); .findall(X, r2(X), M); .print(L, M).
+!r(X)[source(S)] <- .print("goal ", X, " of ", S).
+r(X)[source(S)] <- .print("event ", X, " of ", S).
// agent zoe
+!show <- .findall(X, r(X), L); .print(L).
+!r(X)[source(S)] <- .print("goal ", X, " of ", S).
+r(X)[source(S)] <- .print("event ", X, " of ", S).
+!kqml_received(_, unknown, _, _).
-!kqml_received(_, P, _, _)[error(E)] <- .print(P, " ", E).
// expect [amy]: [2,1][]
// expect [amy]: [][]
// expect [amy]: [4][]
// expect [amy]: goal 5 of bob
// expect [amy]: event 6 of bob
// expect [zoe]: tell no_applicable
// expect [zoe]: []
// expect [zoe]: []
// expect [zoe]: tell no_applicable
// expect [zoe]: []
// expect [zoe]: goal 5 of bob
// expect [zoe]: event 6 of bob
