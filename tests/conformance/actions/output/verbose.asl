// .verbose takes a level; what is printed comes anyway.
!start.
+!start <- .verbose(2); .print(a); .verbose(1); .print(b).
// expect: a
// expect: b
