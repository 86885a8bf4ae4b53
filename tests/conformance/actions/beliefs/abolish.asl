// .abolish deletes what unifies, whatever its source; it always succeeds; rules stay.
p(1). p(2). q(1)[source(bob)]. r(X) :- p(X). other(1).
!start.
+!start
  <- .abolish(p(2)); .findall(X, p(X), L); .print(L);
     .abolish(q(_)[source(bob)]); .abolish(nothing(_)); .abolish(r(_));
     .count(q(_), N); .findall(X, r(X), R); .print(N, R);
     .abolish(_[source(self)]); .count(p(_), M); .count(other(_), O); .print(M, O).
// expect: [1]
// expect: 0[1]
// expect: 00
