// An initial goal must be known when the program is read.
!X.
+!start <- .print("never").
// expect error 2:2: an initial goal must be a literal
