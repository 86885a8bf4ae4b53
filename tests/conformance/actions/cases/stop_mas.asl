// What .stopMAS does ordinarily, at the boundary, and when it fails.
// expect end: stopped
!start.
+!start <- !failure(".stopMAS"); !boundary(".stopMAS"); !ordinary(".stopMAS").
+!ordinary(".stopMAS") <- .print("bye"); .stopMAS; .wait(10); .print("never").
+!boundary(".stopMAS") <- .stopMAS(1000); .print("until then").
+!failure(".stopMAS") <- .stopMAS(soon).
-!failure(A)[error(E)] <- .print(A, " ", E).
+jag_shutting_down(T) <- .print("told ", T).
// expect: .stopMAS wrong_arguments
// expect: until then
// expect: told 1000
// expect: bye
