// .remove_plan: by label, plan or list; nothing to remove is no failure; another source keeps the plan.
!start.
@a +!g <- .print(a).
@b +!g <- .print(b).
@c +!g <- .print(c).
@d +!g <- .print(d).
@e +!g <- .print(e).
+!start
  <- !g; .remove_plan(a); !g; .remove_plan([b, c]); !g; .remove_plan("@d"); !g; .remove_plan(nothing); !g;
     .add_plan({ @told +!h <- .print(h) }, bob); .remove_plan(told); !h; .remove_plan(told, bob); !failure.
+!failure <- !h; .print("never").
-!failure[error(E)] <- .print(E).
// expect: a
// expect: b
// expect: d
// expect: e
// expect: e
// expect: h
// expect: no_relevant
