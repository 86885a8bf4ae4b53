// A plan for a test is only asked where nothing is believed.
p(1).
+?p(X) <- X = 9.
+?q(X) <- X = 9.
!start.
+!start <- ?p(A); ?q(B); .print(A, B).
// expect: 19
