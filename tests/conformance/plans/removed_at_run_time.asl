// A plan can be removed by its label.
!start.
+!start <- !g; .remove_plan(best); !g.
@best +!g <- .print("best").
+!g <- .print("other").
// expect: best
// expect: other
