// A variable as formula must have a value.
!start.
+!start <- X; .print("never").
-!start[error(E)] <- .print(E).
// expect: body_var_without_value
