// .drop_all_desires: intentions and events for goals; the current one goes on.
!start.
+!start <- !!a; .wait(20); !!b; .drop_all_desires; .wait(200); .print("end").
+!a <- .wait(100); .print("never").
+!b <- .print("never").
// expect: end
