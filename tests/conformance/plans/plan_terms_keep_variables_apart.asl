// A plan that is a term has its own variables once it is added.
!start.
+!start <- X = 5; .add_plan({ +!show(Y) <- .print(X, Y) }); !show(1).
// expect: 51
