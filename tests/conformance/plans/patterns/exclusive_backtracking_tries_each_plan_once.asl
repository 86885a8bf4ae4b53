// ebdg: no plan is tried twice for the same goal.
!start.
+!start <- !open(door); .print("goes in").
{ begin ebdg(open(door)) }
+!open(door) <- .print("push").
+!open(door) <- .print("pull").
+!open(door) <- .print("kick"); +open(door); .print("never").
{ end }
// expect: push
// expect: pull
// expect: kick
// expect: goes in
