// .perceive succeeds; what is there to perceive is believed.
// environment: board
!start.
+!start <- show(a); .perceive; .print("seen").
// expect: seen
