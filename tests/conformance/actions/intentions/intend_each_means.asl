// .intend and .desire: an answer for each intended means that has the goal, the topmost first.
!start.
+!start <- !g(1).
+!g(X) : X < 3 <- !g(X + 1); X < 3.
+!g(_) <- .findall(X, .intend(g(X)), L); .findall(X, .desire(g(X)), D); .print(L, D); .intend(g(Y)); .print(Y).
// expect: [3,2,1][3,2,1]
// expect: 3
