// .range counts up or down, and tests whether a number is within.
!start.
+!start
  <- .findall(X, .range(X, 1, 4), L); .print(L); .findall(X, .range(X, 1, 8, 3), M); .print(M);
     .findall(X, .range(X, 3, 1, -1), N); .print(N); .findall(X, .range(X, 3, 1), O); .print(O);
     if (.range(2, 1, 3) & not .range(4, 1, 3)) { .print("within") }.
// expect: [1,2,3,4]
// expect: [1,4,7]
// expect: [3,2,1]
// expect: []
// expect: within
