// A variable in an annotation matches one of the belief's annotations, also if all arguments are ground.
// Matched annotations are removed. Without a source left the belief is deleted: only then there is an
// event, and only then the variables get values.
served[source(bob)].
p(a).
q(1, f(2), "s")[t(5)].
~r(a)[source(ann), u].
told(a)[source(ann), source(bob)].
kept(a)[t(1), source(ann), source(bob)].
!start.
+!start
  <- -served[source(_)]; if (served) { .print(still) } else { .print(gone) };
     -p(a)[source(X)]; .print(X);
     -q(1, f(2), "s")[t(T)]; .print(T); .count(q(_, _, _), N); .print(N);
     -~r(a)[source(A), U]; .print(A, " ", U); .count(~r(_), M); .print(M);
     Z = a; -told(Z)[source(S)]; if (.ground(S)) { .print(S) } else { .print(open) };
     -told(Z)[source(W)]; .print(W); .count(told(_), K); .print(K);
     -kept(a)[t(V), source(bob)]; if (.ground(V)) { .print(V) } else { .print(open) }; ?kept(a)[|L]; .print(L);
     --kept(a)[source(Y)]; if (.ground(Y)) { .print(Y) } else { .print(open) }; .count(kept(_), J); .print(J).
-served[source(S)] <- .print("not served, said ", S).
-told(_)[source(S)] <- .print("not told by ", S).
-kept(_)[|L] <- .print(L).
// expect: not served, said bob
// expect: gone
// expect: self
// expect: 5
// expect: 0
// expect: ann u
// expect: 0
// expect: open
// expect: not told by bob
// expect: bob
// expect: 0
// expect: open
// expect: [source(ann)]
// expect: [source(ann)]
// expect: open
// expect: 0
