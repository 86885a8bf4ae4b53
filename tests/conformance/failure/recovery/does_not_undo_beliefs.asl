// What was believed and done before the failure stays.
!start.
+!start <- !risky; .findall(X, mark(X), L); .print(L).
+!risky <- +mark(1); +mark(2); .fail.
-!risky <- +mark(3).
// expect: [3,2,1]
