// dg: the belief ends the goal wherever its plan is.
!start.
!help.
+!start <- !open(door); .print("goes on").
+!help <- .wait(20); +open(door).
{ begin dg(open(door)) }
+!open(door) <- .print("waits"); .wait(1000); .print("never").
{ end }
// expect: waits
// expect: goes on
