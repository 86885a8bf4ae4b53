// The reason of a .wait has its time.
!start.
+!start <- !!a; .wait(10); .suspended(a, wait(_)[time(T)]); .print(T).
+!a <- .wait(50).
// expect: 50
