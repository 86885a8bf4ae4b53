// A goal with a condition is achieved when that holds.
!start.
+!start <- !wait_for_it; .print("achieved").
+!wait_for_it <: ready <- .print("working"); .wait(1000); .print("never").
!helper.
+!helper <- .wait(100); +ready.
// expect: working
// expect: achieved
