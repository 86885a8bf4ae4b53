// A rule's body may ask for annotations; its own answers have source(self).
b(1)[k]. b(2)[source(bob)].
r(X) :- b(X)[k].
s(X) :- b(X)[source(bob)].
!start.
+!start : r(A) & s(B) & r(A)[source(self)] & not r(A)[k] <- .print(A, " ", B).
// expect: 1 2
