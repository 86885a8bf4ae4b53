// .stopMAS ends the run.
// expect end: stopped
!start.
+!start <- .print("bye"); .stopMAS.
// expect: bye
