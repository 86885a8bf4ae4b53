// .clone: a fork of which a branch waits for time is the original's alone; so are the forks in it.
!both.
!copy.
+!both <- (.wait(30) |&| !inner); .print("joined").
+!inner <- (!left |&| !right).
+!left <- +a; +b; +c; +d.
+!right <- +e; +f; +g; +h.
+!copy <- -+ready; .clone(twin); .wait(100); .send(twin, askOne, d, A); .print(A).
// expect: joined
// expect: false
