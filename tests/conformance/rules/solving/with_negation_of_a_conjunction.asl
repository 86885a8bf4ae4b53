// `not` holds if there is no solution, and binds nothing.
p(1). p(2). q(2).
only(X) :- p(X) & not q(X).
none :- not (p(X) & q(X) & X > 5).
!start.
+!start : none <- .findall(X, only(X), L); .print(L).
// expect: [1]
