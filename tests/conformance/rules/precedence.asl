// & binds tighter than |.
a(1). c(3).
p(X) :- b(X) & a(Y) | c(X).
!start.
+!start <- .findall(X, p(X), L); .print(L).
// expect: [3]
