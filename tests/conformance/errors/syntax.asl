// A program that cannot be read is refused.
!start.
+!start <- .print("x"
// expect error 5:1: expected ',' or ')', found the end of the text
