// A variable as annotation stands for each of them in turn.
b[a, m, z(1)].
!start.
+!start <- .findall(X, b[X], L); .sort(L, S); .print(S).
// expect: [a,m,source(self),z(1)]
