// .succeed_goal and .fail_goal end all goals that match, and leave the variable open.
!start.
+!job(N) <- .wait(10000); .print(never).
-!job(N) <- .print("failed ",N).
+!wr(N) <- !job(N); .print("after ",N).
+!start <- !!wr(1); !!wr(2); !!wr(3); .wait(30); .succeed_goal(job(X)); .print(X); .wait(20);
  !!wr(4); !!wr(5); .wait(30); .fail_goal(job(Y)); .print(Y); .wait(20);
  !!wr(6); !!wr(7); .wait(30); .succeed_goal(job(6)); .wait(20); .print("--");
  !!job(8); !!job(9); .wait(20); .succeed_goal(job(_)); .print("end").
// expect: after 1
// expect: after 2
// expect: after 3
// expect: X<no-value>
// expect: Y<no-value>
// expect: failed 4
// expect: failed 5
// expect: after 4
// expect: after 5
// expect: after 6
// expect: --
// expect: after 7
// expect: end
