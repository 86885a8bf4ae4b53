// A belief that is added later is found earlier.
b(1). b(2).
!start.
+!start <- +b(3); .findall(X, b(X), L); .print(L).
// expect: [3,1,2]
