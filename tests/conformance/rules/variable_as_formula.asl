// A variable in a formula stands for the formula that it is bound to.
b(1). b(2).
holds(F) :- F.
!start.
+!start <- .findall(X, holds(b(X)), L); .print(L); F = (b(X) & X > 1); ?F; .print(X).
// expect: [1,2]
// expect: 2
