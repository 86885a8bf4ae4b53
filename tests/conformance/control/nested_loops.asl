// Loops nest.
!start.
+!start <- for (.range(I, 1, 2)) { for (.range(J, 1, 2)) { .print(I, J) }; .print("row ", I) }.
// expect: 11
// expect: 12
// expect: row 1
// expect: 21
// expect: 22
// expect: row 2
