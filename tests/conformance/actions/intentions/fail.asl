// .fail: ia_failed; with annotations internal_action, and they are at the failure event.
!start.
+!start <- !plain; !annotated; if (.fail) { .print("bad") } else { .print("no solution") }.
+!plain <- .fail; .print("never").
-!plain[error(E)] <- .print(E).
+!annotated <- .fail(why(rain), error_msg("too wet")); .print("never").
-!annotated[error(E), error_msg(M), why(W)] <- .print(E, " ", M, " ", W).
// expect: ia_failed
// expect: internal_action too wet rain
// expect: no solution
