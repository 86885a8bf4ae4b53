// .verbose takes a level: 2 shows what is fine, too.
!start.
+!start <- .log(fine,no); .verbose(2); .log(fine,a); .verbose(1); .log(fine,no); .print(b).
// expect: a
// expect: b
