// In older Jasons labels may have arguments; here such a plan has its annotations, but no label.
!go.
@ go(_, "x")[atomic]
+!go <- !!other; .print(a); .print(b).
@found("gold", X)
+!other <- +found("gold", 1); +found("iron", 2).
@found("gold", Y)
+found("gold", N) <- .print(gold, N).
@found("iron", Y)
+found("iron", N) <- .print(iron, N).
// expect: a
// expect: b
// expect: gold1
// expect: iron2
