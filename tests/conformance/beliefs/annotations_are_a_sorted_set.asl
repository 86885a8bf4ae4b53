// Annotations are sorted and without duplicates.
b(1)[z, a, k(2), a].
!start.
+!start <- ?b(1)[|T]; .print(T).
// expect: [a,k(2),source(self),z]
