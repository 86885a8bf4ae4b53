// .findall: in order, with duplicates; [] if there is no solution; the list may be known.
b(2). b(1). b(2).
c(2, x). c(1, y).
!start.
+!start
  <- .findall(f(X, Y), c(X, Y), L); .print(L); .findall(X, none(X), E); .print(E);
     .findall(X, c(X, _) & X > 1, [2]); .print("as expected"); !failure.
+!failure <- .findall(X, c(X, _), [1]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [f(2,x),f(1,y)]
// expect: []
// expect: as expected
// expect: ia_failed
