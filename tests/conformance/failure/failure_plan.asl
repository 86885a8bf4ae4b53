// -!g runs when g fails; then the caller goes on as if g had been achieved.
!start.
+!start <- !g; .print("after").
+!g <- .print("trying"); .fail; .print("never").
-!g <- .print("repaired").
// expect: trying
// expect: repaired
// expect: after
