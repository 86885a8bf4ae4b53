// Of several goals of one intention that match, the topmost says which: those below that are not
// like it go on.
!start.
+!job(0) <- .wait(1000).
+!job(N) <- !job(N-1); .print("job after ",N).
+!wr(N) <- !job(N); .print("after ",N).
-!job(N) <- .print("failed ",N).
+!start <- !!wr(2); .wait(20); .succeed_goal(job(_)); .wait(20); !!wr(3); .wait(20); .fail_goal(job(_)); .wait(20);
 !!wr(4); .wait(20); .succeed_goal(job(2)); .wait(20); .print(end).
// expect: job after 1
// expect: job after 2
// expect: after 2
// expect: failed 0
// expect: job after 1
// expect: job after 2
// expect: job after 3
// expect: after 3
// expect: job after 3
// expect: job after 4
// expect: after 4
// expect: end
