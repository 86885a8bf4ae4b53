// A variable as trigger takes every goal, in its place in the order.
!a. !b(1).
+!a <- .print("a itself").
+!G[source(self)] <- .print(G).
// expect: a itself
// expect: b(1)
