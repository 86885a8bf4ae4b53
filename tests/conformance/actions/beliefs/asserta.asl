// .asserta adds in front, with source(self) unless there is a source; rules too.
p(1).
!start.
+!start
  <- .asserta(p(2)); .asserta(p(3)[source(bob)]); .asserta({ r(X) :- p(X) & X > 1 });
     .findall(p(X, S), p(X)[source(S)], L); .print(L); .findall(X, r(X), R); .print(R).
// expect: [p(3,bob),p(2,self),p(1,self)]
// expect: [3,2]
