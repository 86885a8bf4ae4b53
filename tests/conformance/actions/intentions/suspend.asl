// .suspend and .resume: by goal, and itself; what is not there is no failure.
!start.
+!start
  <- !!a; !!self; .wait(20); .suspend(a); .suspend(none); .wait(100); .print("a waits"); .resume(a); .resume(self); .resume(none); .wait(200); .print("end").
+!a <- .wait(50); .print("a goes on").
+!self <- .print("before"); .suspend; .print("after").
// expect: before
// expect: a waits
// expect: a goes on
// expect: after
// expect: end
