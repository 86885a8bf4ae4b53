// A context is looked at once, before the body.
p.
!start.
+!start : p <- -p; ?not p; .print("goes on").
// expect: goes on
