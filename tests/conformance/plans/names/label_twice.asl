// A label is unique.
@l +!a <- .print(a).
@l +!b <- .print(b).
// expect error 3:2: another plan has the label 'l' already
