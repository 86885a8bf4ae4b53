// .get_src_info adds where a literal stands in the source.
!start.
+!start
  <- .get_src_info(p(1), R); R =.. [_, F, Args, Annots]; .print(F, Args);
     if (.member(code_line(L), Annots) & .number(L)) { .print("has a line") }; !failure.
+!failure <- .get_src_info(p(1), q); .print("never").
-!failure[error(E)] <- .print(E).
// expect: p[1]
// expect: has a line
// expect: ia_failed
