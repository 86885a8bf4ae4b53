// Rules may call themselves.
edge(a, b). edge(b, c). edge(c, d).
path(X, Y) :- edge(X, Y).
path(X, Y) :- edge(X, Z) & path(Z, Y).
!start.
+!start <- .findall(Y, path(a, Y), L); .print(L).
// expect: [b,c,d]
