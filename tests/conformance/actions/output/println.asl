// .println is .print, as far as lines go.
!start.
+!start <- .println("a ", 1, " ", [b]); .println(X); .print("next").
// expect: a 1 [b]
// expect: X<no-value>
// expect: next
