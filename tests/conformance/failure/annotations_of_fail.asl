// The arguments of .fail become annotations of the failure.
!start.
+!start <- !g.
+!g <- .fail(reason(rain), level(3)).
-!g[reason(R), level(N)] <- .print(R, N).
// expect: rain3
