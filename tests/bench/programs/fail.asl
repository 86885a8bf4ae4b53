// A goal that fails, and whose failure a plan handles.
n(100).
!start.
+!start : n(N) <- !each(N).
+!each(0).
+!each(N) <- !goal(N); !each(N-1).
+!goal(_) <- .fail.
-!goal(_).
