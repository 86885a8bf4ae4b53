// Deleting with annotations and a source deletes only these; the belief keeps what remains.
b(1)[k, m, source(bob), source(self)].
!start.
+!start <- -b(1)[k, source(bob)]; ?b(1)[|T]; .print(T).
// expect: [m,source(self)]
