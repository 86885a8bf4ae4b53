// not F holds if F has no solution, and binds nothing.
b(1). b(2). c(2).
only(X) :- b(X) & not c(X).
!start.
+!start <- .findall(X, only(X), L); .print(L); ?(not b(3)); .print("no three").
// expect: [1]
// expect: no three
