// The failure plan is looked for by name and arity; its arguments are compared only then.
!start.
+!start <- !a(1); .print("never").
+!a(_) <- .fail.
-!a(2) <- .print("never").
-!start <- .print("never").
!watch.
+!watch <- .wait(10); .print("end").
// expect: end
