// `-b(X)` gives X the value of what it deletes; `--b(X)`, which is another intention's affair, does not,
// nor does a deletion that leaves the belief with another source.
told(1)[source(bob)]. told(2).
v(1). v(2).
!go.
+!go
  <- --v(X); .print(X); .count(v(_), N); .print(N);
     -v(Y); .print(Y);
     +told(1); -told(Z); .print(Z); ?told(1)[source(S)]; .print(S);
     -told(W); .print(W).
// expect: X<no-value>
// expect: 1
// expect: 2
// expect: Z<no-value>
// expect: bob
// expect: 2
