// .assertz adds behind, without a source.
p(1).
!start.
+!start <- .assertz(p(2)); .assertz(p(3)[source(bob)]); .findall(p(X)[|A], p(X)[|A], L); .print(L).
// expect: [p(1)[source(self)],p(2),p(3)[source(bob)]]
