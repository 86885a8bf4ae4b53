// .add_plan: a plan, a text, a list of them; at the begin or the end; a label that is taken is an error.
!start.
@known +!old <- .print("old").
+!start
  <- .add_plan({ +!new <- .print("added") }); !new; .add_plan("+!text(X) <- .print(X).", self); !text(5);
     .add_plan({ +!old <- .print("before") }, self, begin); !old; .add_plan({ +!old <- .print("after") }, self, end); !old;
     .add_plan([{ +!l1 <- .print(l1) }, { +!l2 <- .print(l2) }]); !l1; !l2; !failure; !syntax.
+!failure <- .add_plan({ @known +!other <- .print("other") }); .print("never").
-!failure[error(E)] <- .print("label taken").
+!syntax <- .add_plan("+!x <- ( ."); .print("never").
-!syntax[error(E)] <- .print("no plan").
// expect: added
// expect: 5
// expect: before
// expect: before
// expect: l1
// expect: l2
// expect: label taken
// expect: no plan
