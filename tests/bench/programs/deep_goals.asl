// An intention of a million means, each of which has something left to do.
n(1000000).
!start.
+!start : n(N) <- !down(N, Depth); .print(Depth).
+!down(0, 0).
+!down(N, Depth) <- !down(N-1, Below); Depth = Below + 1.
