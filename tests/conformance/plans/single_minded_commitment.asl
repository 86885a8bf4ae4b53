// The failed goal is off the stack when its failure is handled, so that it is tried again.
{ begin smc(g,f) }
+!g <- .print(try); .wait(50); +g.
{ end }
!start.
+!w <- !g; .print(after).
+!start <- !!w; .wait(20); +f; .wait(100); .print(end).
// expect: try
// expect: try
// expect: after
// expect: end
