// unachieve ends a goal that is pursued.
// agent bob
+!work <- .print("begins"); .wait(100); .print("never").
// agent ann
!start.
+!start <- .send(bob, achieve, work); .wait(20); .send(bob, unachieve, work).
// expect [bob]: begins
