// An external event without a plan does not cost a cycle.
!a.
+!a <- ++x; ++y; .print(a1).
!b.
+!b <- .print(b1).
// expect: b1
// expect: a1
