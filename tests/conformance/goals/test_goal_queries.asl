// ? binds by the first solution of a query.
b(1). b(2).
!start.
+!start <- ?b(X); .print(X); ?b(Y) & Y > 1; .print(Y).
// expect: 1
// expect: 2
