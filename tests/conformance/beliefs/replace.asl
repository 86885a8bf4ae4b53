// -+b deletes one belief of that name and arity, then adds.
b(1). b(2).
!start.
+!start <- -+b(5); .findall(X, b(X), L); .print(L).
// expect: [5,2]
