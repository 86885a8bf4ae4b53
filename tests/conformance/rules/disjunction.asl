// The left of a disjunction is tried first, with the bindings from before.
b(1). c(2).
any(X) :- b(X) | c(X).
!start.
+!start <- .findall(X, any(X), L); .print(L).
// expect: [1,2]
