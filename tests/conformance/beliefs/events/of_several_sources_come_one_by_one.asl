// A belief that is held already has an event for each new source, with that alone.
!start.
+!start <- +b; +b[source(bob)]; +b[source(bob)]; ?b[source(bob)]; .print("both").
+b[source(S)] <- .print(S).
// expect: self
// expect: bob
// expect: both
