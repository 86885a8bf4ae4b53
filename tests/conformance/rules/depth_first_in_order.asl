// Rules and facts answer in their common order.
p(1). p(X) :- q(X). p(4).
q(2). q(3).
!start.
+!start <- .findall(X, p(X), L); .print(L).
// expect: [1,2,3,4]
