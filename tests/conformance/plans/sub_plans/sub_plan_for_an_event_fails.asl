// A sub-plan for an event that fails looks for a plan for the failure down the stack of the goal
// that it belongs to. The handled goal's caller goes on, once.
!start.
+!start <- !!g; .wait(20); ++e; .wait(100); .print("--"); !!g2; .wait(20); ++e2; .wait(100); .print("--");
   !!g3; .wait(20); ++e3; .wait(100).
+!g <- .print(g); !h; .print(end_g).
+!h <- .print(h); .wait(60); .print(end_h). { +e <- .print(e); !x. +!x <- .fail. }
-!h <- .print(handler).
+!g2 <- !h2; .print(end_g2).
+!h2 <- .wait(60); .print(end_h2). { +e2 <- .print(e2); .fail.  -!h2 <- .print(inner_handler). }
+!g3 <- .wait(60); .print(end_g3). { +e3 <- .print(e3); !y. +!y <- .fail.  -!y <- .print(handled). }
// expect: g
// expect: h
// expect: e
// expect: handler
// expect: end_g
// expect: end_h
// expect: --
// expect: e2
// expect: inner_handler
// expect: end_g2
// expect: end_h2
// expect: --
// expect: e3
// expect: handled
// expect: end_g3
