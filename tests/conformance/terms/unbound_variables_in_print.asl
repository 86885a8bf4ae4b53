// An unbound variable prints with <no-value>, within a term by its name.
!start.
+!start <- .print(X); .print(f(X)).
// expect: X<no-value>
// expect: f(X)
