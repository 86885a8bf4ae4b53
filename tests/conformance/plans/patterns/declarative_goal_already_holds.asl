// dg: a goal that is believed already needs no plan.
open(door).
!start.
+!start <- !open(door); .print("nothing to do").
{ begin dg(open(door)) }
+!open(door) <- .print("never"); +open(door).
{ end }
// expect: nothing to do
