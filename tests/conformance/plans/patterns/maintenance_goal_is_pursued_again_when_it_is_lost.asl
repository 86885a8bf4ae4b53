// mg: the goal is believed at first; when it is lost, it is pursued.
!start.
+!start <- .wait(20); .print("gets cold"); -warm(room).
{ begin mg(warm(room)) }
+!warm(room) <- .print("lights the fire"); +warm(room).
{ end }
// expect: gets cold
// expect: lights the fire
