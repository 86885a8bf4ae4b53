// .drop_all_events: what was not begun is not begun.
!start.
+!start <- !!a; .wait(20); !drop; .wait(200); .print("end").
@drop[atomic] +!drop <- !!b; .drop_all_events.
+!a <- .wait(100); .print("a goes on").
+!b <- .print("never").
// expect: a goes on
// expect: end
