// Nothing is deleted unless all annotations are there.
b(1)[k].
!start.
+!start <- -b(1)[k, m]; ?b(1)[|T]; .print(T).
// expect: [k,source(self)]
