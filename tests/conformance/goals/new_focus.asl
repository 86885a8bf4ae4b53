// !! starts an intention of its own; its caller goes on at once.
!start.
+!start <- !!slow; .print("start").
+!slow <- .print("slow").
// expect: start
// expect: slow
