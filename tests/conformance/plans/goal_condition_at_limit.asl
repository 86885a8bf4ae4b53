// A goal whose condition cannot be decided within the limits fails, as a formula does.
// limit inferences 1000
!start.
endless(X) :- endless(X).
+!start <- !wait_for_it; .print("goes on").
+!wait_for_it <: endless(1) <- .wait(1000); .print("never").
-!wait_for_it[error(E), error_msg(M)] <- .print(E, ": ", M).
// expect: limit: a query took more than 1000 inferences
// expect: goes on
// expect log: the goal wait_for_it[source(self)] fails, since its condition cannot be decided: a query took more than 1000 inferences
