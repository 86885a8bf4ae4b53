// .abolish leaves rules alone.
b(1). b(X) :- c(X). c(9).
!start.
+!start <- .abolish(b(_)); .findall(X, b(X), L); .print(L).
// expect: [9]
