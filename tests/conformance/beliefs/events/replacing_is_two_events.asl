// -+b(2) deletes b(1), which is an event by itself, and adds b(2), for which it waits.
b(1).
!start.
+!start <- -+b(2); .findall(X, b(X), L); .print(L).
-b(X) <- .print("no longer ", X).
+b(X) <- .print("now ", X).
// expect: now 1
// expect: no longer 1
// expect: now 2
// expect: [2]
