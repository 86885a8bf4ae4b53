// Lists element by element; a beginning comes before the whole.
!start.
+!start <- .sort([[2], [1, 5], [1], [], [1, 2, 3]], L); .print(L).
// expect: [[],[1],[1,2,3],[1,5],[2]]
