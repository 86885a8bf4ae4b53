// The place is that of the formula which asks.
// expect: p(1)[code_line(4),code_src("file:agent.asl")]
!start.
+!start <- .get_src_info(p(1),R); .print(R).
