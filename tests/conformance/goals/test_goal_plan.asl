// A test goal without an answer is handled by a plan +?.
!start.
+!start <- ?speed(V); .print(V).
+?speed(V) <- .print("asked"); V = 30.
// expect: asked
// expect: 30
