// tellHow gives the receiver a plan.
// agent ann
!start.
+!start <- .send(bob, tellHow, "+!dance <- .print(\"dancing\")."); .wait(100); .send(bob, achieve, dance).
// agent bob
idle.
// expect [bob]: dancing
