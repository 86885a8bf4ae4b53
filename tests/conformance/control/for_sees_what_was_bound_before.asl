// Bindings from before the loop hold within it.
!start.
+!start <- Z = 10; for (.range(I, 1, 2)) { .print(Z + I) }; .print(Z).
// expect: 11
// expect: 12
// expect: 10
