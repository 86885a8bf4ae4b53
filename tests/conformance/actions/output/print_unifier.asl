// .print_unifier prints the variables that have a value, a line each, and that it is done.
!start.
+!start <- .print_unifier; X = 1; Y = f("a"); .print_unifier.
// expect: done
// expect: X=1
// expect: Y=f("a")
// expect: done
