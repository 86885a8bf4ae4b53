// {begin dg(g)}: a goal that is believed is achieved.
on.
!on.
{ begin dg(on) }
+!on <- .print("never").
{ end }
!start.
+!start <- !on; .print("on already").
// expect: on already
