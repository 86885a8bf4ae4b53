// -+b[t(X)] replaces a belief that has such an annotation, without binding X.
p(1)[t(5)]. p(2)[t(6)].
z[t(7)].
!start.
+!start
  <- -+p(3)[t(X)]; if (.ground(X)) { .print(X) } else { .print(open) };
     .findall(A, p(A), L); .print(L); ?p(3)[t(8)]; .print(any);
     -+z[t(Y)]; if (.ground(Y)) { .print(Y) } else { .print(open) }; ?z[t(8)]; .print(any).
-p(X)[t(T)] <- .print("not ", X, " ", T).
-z[t(T)] <- .print("not z ", T).
// expect: not 1 5
// expect: open
// expect: [3,2]
// expect: any
// expect: not z 7
// expect: open
// expect: any
