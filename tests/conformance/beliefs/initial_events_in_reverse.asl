// Initial beliefs are added from the last to the first, and so come their events.
b(1). b(2). c(3).
+b(X) <- .print(b(X)).
+c(X) <- .print(c(X)).
// expect: c(3)
// expect: b(2)
// expect: b(1)
