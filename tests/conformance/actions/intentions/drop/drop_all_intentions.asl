// .drop_all_intentions: all but the current one.
!start.
+!start <- !!a; !!b; .wait(20); .drop_all_intentions; .wait(200); .print("end").
+!a <- .wait(100); .print("never").
+!b <- .wait({ +none }); .print("never").
// expect: end
