// -+b of what is not believed just adds.
!start.
+!start <- -+b(2); ?b(X); .print(X).
// expect: 2
