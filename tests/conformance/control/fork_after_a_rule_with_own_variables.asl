// What a rule of the condition has bound in variables of its own is no part of a round: a fork in
// the round copies what the agent has, and nothing else.
at(1, 2). n(1). n(7) :- at(1, _).
at(X, 9) :- n(X) & X < 2.
!start.
+!start <- for (n(Z)) { !in(Z) }; .print(end).
+!in(Z) <- { .print(a, Z) } |&| { .print(b, Z) }.
// expect: a1
// expect: b1
// expect: a7
// expect: b7
// expect: a7
// expect: b7
// expect: end
