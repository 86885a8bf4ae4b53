// .done: the current goal is achieved; what posted it goes on.
!start.
+!start <- !g; .print("after g").
+!g <- .print("g"); .done; .print("never").
// expect: g
// expect: after g
