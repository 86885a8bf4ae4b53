// .add_annot keeps an open set of annotations open.
!start.
+!start <- .add_annot(p(1)[|T], u, R); .print(R); .add_annot(p(1)[v|S], u, Q); .print(Q).
// expect: p(1)[u|T]
// expect: p(1)[u,v|S]
