// A goal that fails and is tried again for ever ends at the limit.
// limit cycles 5000
// expect end: limit
!g.
+!g <- .fail.
-!g <- !!g.
