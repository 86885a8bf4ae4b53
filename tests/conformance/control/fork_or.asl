// ||| goes on when the first branch is done; the others are dropped.
!start.
+!start <- (.print(a1)) ||| (.print(b1); .print(b2); .print(b3)); .print("end").
// expect: a1
// expect: b1
// expect: end
