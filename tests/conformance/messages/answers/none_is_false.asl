// Who knows no answer says so.
// agent bob
other.
// agent ann
!start.
+!start <- .send(bob, askOne, price(_), A); .print(A); .send(bob, askAll, price(_), L); .print(L).
// expect [ann]: false
// expect [ann]: []
