// A different plan with a label that is taken is an error.
@l +!g <- .print(a).
@l +!g <- .print(b).
// expect error 3:2: another plan has the label 'l' already
