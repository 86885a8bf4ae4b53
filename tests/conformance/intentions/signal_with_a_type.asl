// With type_signal what is made is no goal, whatever the trigger says, and has the annotation signal.
// Another type, or a text, changes nothing.
!start.
+!start
  <- .signal({ +!ask(1) }, type_signal); .signal({ +ev(2) }, type_signal);
     .signal({ +ev(3) }, other); .signal({ +ev(4) }, "type_signal"); .signal({ +!ask(5) }).
+!ask(X) <- .print("goal ", X).
+ask(X)[signal] <- .print("signal ", X).
+ev(X)[signal] <- .print("signal ", X).
+ev(X) <- .print("event ", X).
// expect: signal 1
// expect: signal 2
// expect: event 3
// expect: event 4
// expect: goal 5
