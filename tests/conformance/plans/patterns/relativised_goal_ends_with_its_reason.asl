// rc: when the motivation goes, the goal is given up as if achieved.
raining.
!start.
!sun.
+!start <- !dry(hair); .print("no longer needed").
+!sun <- .wait(20); -raining.
{ begin rc(dry(hair), raining) }
+!dry(hair) <- .print("looks for a towel"); .wait(1000); .print("never").
{ end }
// expect: looks for a towel
// expect: no longer needed
