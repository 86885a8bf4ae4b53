// What a query in .findall or .count binds is not known outside.
b(1).
!start.
+!start <- .findall(X, b(X), _); .count(b(Y), _); .print(X, Y).
// expect: X<no-value>Y<no-value>
