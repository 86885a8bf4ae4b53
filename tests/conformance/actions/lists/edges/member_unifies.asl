// .member tries each element, and unifies with it.
!start.
+!start
  <- .findall(X, .member(f(X, b), [f(1, b), f(2, c), g(3), f(4, b)]), L); .print(L); .findall(Y, .member(Y, []), M); .print(M);
     if (.member(2, [1, 2]) & not .member(3, [1, 2])) { .print("so it is") }.
// expect: [1,4]
// expect: []
// expect: so it is
