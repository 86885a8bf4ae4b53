// A failure within a loop fails the goal.
!start.
+!start <- for (.member(X, [1, 2, 3])) { .print(X); X < 2 }; .print("never").
-!start <- .print("failed").
// expect: 1
// expect: 2
// expect: failed
