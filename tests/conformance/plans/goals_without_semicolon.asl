// As in Jason, a goal may follow without a semicolon.
!start.
+!start <- .print(a)
           !b
           ?c(X); .print(X).
+!b <- .print(b).
c(c).
// expect: a
// expect: b
// expect: c
