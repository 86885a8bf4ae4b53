// An initial belief with variables holds for all values.
likes(bob, _).
!start.
+!start <- ?likes(bob, cake); .print("yes"); ?(not likes(ann, cake)); .print("no").
// expect: yes
// expect: no
