// Each that is asked for has to be there.
b[a].
!start.
+!start : b[a] & not b[z] & not b[a, z] & b[] <- .print("so it is").
// expect: so it is
