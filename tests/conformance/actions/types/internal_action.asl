// .internal_action: whether a term names one.
!start.
+!start <- T = .print(1); if (.internal_action(T)) { .print("one") }; if (not .internal_action(print(1))) { .print("none") }; !failure.
+!failure <- .internal_action(a); .print("never").
-!failure[error(E)] <- .print(E).
// expect: one
// expect: none
// expect: ia_failed
