// A label may have annotations that say nothing to the interpreter.
!start.
@one[priority(3), cost(2)] +!start <- .print("labelled").
// expect: labelled
