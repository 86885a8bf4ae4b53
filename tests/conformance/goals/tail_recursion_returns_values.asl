// Values come back through goals that gave way to their last call.
!start.
+!start <- !sum([1, 2, 3, 4], 0, S); .print(S).
+!sum([], A, A).
+!sum([H|T], A, S) <- !sum(T, A + H, S).
// expect: 10
