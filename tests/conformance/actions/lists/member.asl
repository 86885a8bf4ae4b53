// .member goes through the elements.
!start.
+!start <- .findall(X, .member(X, [a, b, a]), L); .print(L); ?(not .member(z, [a])); .member(f(Y), [g(1), f(2)]); .print(Y).
// expect: [a,b,a]
// expect: 2
