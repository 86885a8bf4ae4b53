// A belief that is not ground may be added at run time; each query sees fresh variables.
!start.
+!start <- +b(_, k); ?b(1, X); ?b(2, Y); .print(X, Y).
// expect: kk
