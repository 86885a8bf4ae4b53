// `not X > 1` is not (X > 1).
b(1). b(2).
small(X) :- b(X) & not X > 1.
!start.
+!start <- .findall(X, small(X), L); .print(L).
// expect: [1]
