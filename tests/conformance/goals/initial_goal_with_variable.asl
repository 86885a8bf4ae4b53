// A variable of an initial goal is free.
!greet(_).
+!greet(X) <- .print("hello"); X = 1.
// expect: hello
