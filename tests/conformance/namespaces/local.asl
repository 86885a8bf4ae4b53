// No variable takes the name of a namespace that is a file's own; within it all works as elsewhere.
{ begin namespace(m,local) }
q(a).
!go.
+!go
  <- G = g(1); !G; ?q(K); .print(K); V = m::k(1); .print(V); +r(2); ?m::r(Z); .print(Z); !hidden.
+!g(X) <- .print("g ",X).
+!hidden <- ?N::q(_); .print(N).
-!hidden[error(E)] <- .print(E).
{ end }
// expect: g 1
// expect: a
// expect: k(1)
// expect: 2
// expect: test_goal_failed
