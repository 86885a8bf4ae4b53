// Facts and rules of one name answer in the order of the program.
p(1).
p(X) :- q(X).
p(4).
q(2). q(3).
!start.
+!start <- .findall(X, p(X), L); .print(L).
// expect: [1,2,3,4]
