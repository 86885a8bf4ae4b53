// A loop without end stops at the limit of cycles.
// limit cycles 1000
// expect end: limit
!start.
+!start <- .print("begin"); while (true) { +b; -b }; .print("never").
// expect: begin
