// The event of a belief that gets annotations has only the new ones.
b(1).
!start.
+!start <- +b(1)[k]; ?b(1)[k, source(S)]; .print(S).
+b(1)[k] : true <- .print("k is new").
+b(1)[source(self)] <- .print("initial").
// expect: initial
// expect: k is new
// expect: self
