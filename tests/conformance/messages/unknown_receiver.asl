// Sending to nobody fails.
!start.
+!start <- .send(nobody, tell, hello); .print("never").
-!start[error(E)] <- .print(E).
// expect: receiver_not_found
