// sga: while one such goal is pursued, others wait for their turn.
!start.
+!start <- +job(1); +job(2).
{ begin sga("+job(N)", "true", done(job)) }
{ end }
+!done(job) <- .print("begins"); .wait(20); .print("ends").
// expect: begins
// expect: ends
// expect: begins
// expect: ends
