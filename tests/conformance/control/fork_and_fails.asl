// A branch of |&| that fails fails them all.
!start.
+!start <- (.print(a1); .fail) |&| (.print(b1); .print(b2); .print(b3); .print(b4)); .print("never").
-!start <- .print("failed").
// expect: a1
// expect: b1
// expect: failed
