// .drop_event: events alone; what is intended goes on.
!start.
+!start <- !!a(1); .wait(20); !drop; .wait(30); .drop_event(a(1)); .wait(100); .print("end").
@drop[atomic] +!drop <- !!a(2); .drop_event(none); .drop_event(a(2)).
+!a(X) <- .print("began ", X); .wait(80); .print("ended ", X).
// expect: began 1
// expect: ended 1
// expect: end
