// .sort keeps duplicates; .max and .min follow the order of terms.
!start.
+!start <- .sort([c, 2, a, 2, "s"], L); .print(L); .max([3, 9, 2], M); .min([3, 9, 2], N); .print(M, N).
// expect: [2,2,"s",a,c]
// expect: 92
