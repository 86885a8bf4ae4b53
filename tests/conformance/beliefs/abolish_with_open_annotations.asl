// The pattern may have variables in annotations, also if all arguments are ground.
b(1)[t(5)]. b(2)[t(6)]. b(2)[source(bob)]. b(f(3))[t(6), source(ann)]. ~b(1)[t(5)].
!start.
+!start
  <- .abolish(b(1)[t(_)]); .findall(X, b(X), L); .print(L);
     .abolish(b(2)[source(bob), t(T)]); .findall(X, b(X), M); .print(M);
     Z = f(3); .abolish(b(Z)[A]); .findall(X, b(X), N); .print(N);
     if (.ground(A)) { .print(A) } else { .print(open) };
     .abolish(~b(1)[t(4)]); .count(~b(_), K); .print(K).
-b(X)[|L] <- .print("not ", X, L).
// expect: not 1[]
// expect: [2,f(3)]
// expect: not 2[]
// expect: [f(3)]
// expect: not f(3)[]
// expect: []
// expect: open
// expect: 1
