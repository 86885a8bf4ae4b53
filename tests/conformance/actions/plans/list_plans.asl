// .list_plans succeeds, for any trigger.
!start.
+!start <- .list_plans({ +!none_such }); .print("done").
// expect: done
