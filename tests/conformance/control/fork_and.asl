// |&| goes on when both branches are done.
!start.
+!start <- (.print(a1); .print(a2)) |&| (.print(b1); .print(b2)); .print("end").
// expect: a1
// expect: b1
// expect: a2
// expect: b2
// expect: end
