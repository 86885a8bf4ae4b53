// .member: elements in turn; of sets and queues too; fails if there is none.
!start.
+!start
  <- .findall(X, .member(X, [a, b, a]), L); .print(L); .member(f(Y), [g(1), f(2), f(3)]); .print(Y);
     .findall(X, .member(X, []), E); .print(E);
     .set.create(S); .set.add_all(S, [c, b]); .findall(X, .member(X, S), Z); .print(Z); .member(b, S);
     .queue.create(Q); .queue.add_all(Q, [z, y]); .findall(X, .member(X, Q), W); .print(W); !failure.
+!failure <- .member(z, [a]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [a,b,a]
// expect: 2
// expect: []
// expect: [b,c]
// expect: [z,y]
// expect: ia_failed
