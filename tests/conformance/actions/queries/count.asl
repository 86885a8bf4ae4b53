// .count: an action and a function; it fails if the number is another.
c(1). c(2). c(3).
p(1)[source(ann)]. p(2)[source(bob)]. p(3)[k(1),source(ann)].
!start.
+!start
  <- .count(c(_), N); .print(N); .count(c(X) & X > 1, M); .print(M); .count(none, Z); .print(Z);
     K = .count(c(_)) + 1; .print(K); .count(c(_), 3);
     .count(p(_)[source(ann)], A); .print(A); .count(p(3)[k(_)], B); .print(B); .count(p(_)[k(2)], C); .print(C); !failure.
+!failure <- .count(c(_), 4); .print("never").
-!failure[error(E)] <- .print(E).
// expect: 3
// expect: 2
// expect: 0
// expect: 4
// expect: 2
// expect: 1
// expect: 0
// expect: ia_failed
