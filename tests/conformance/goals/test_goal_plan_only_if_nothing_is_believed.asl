// A plan +? is not asked if the beliefs answer.
speed(10).
!start.
+!start <- ?speed(V); .print(V).
+?speed(V) <- .print("never"); V = 30.
// expect: 10
