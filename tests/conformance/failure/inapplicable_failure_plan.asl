// If the failure plan found is not applicable, the intention is lost; the search does not go on.
!start.
+!start <- !a; .print("never").
+!a <- .fail.
-!a : false <- .print("never").
-!start <- .print("never").
+!watch <- .wait(10); .print("end").
!watch.
// expect: end
