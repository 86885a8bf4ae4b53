// A for over a rule that is satisfied without end takes as many solutions as it has rounds.
nat(0).
nat(N) :- nat(M) & N = M+1.
!start.
+!start <- for (nat(X) & X mod 50 == 0) { .print(X); if (X == 200) { .drop_intention } }.
// expect: 0
// expect: 50
// expect: 100
// expect: 150
// expect: 200
