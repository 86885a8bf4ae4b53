// +> adds behind all others, +< before them.
b(1).
!start.
+!start <- +>b(2); +<b(3); .findall(X, b(X), L); .print(L).
// expect: [3,1,2]
