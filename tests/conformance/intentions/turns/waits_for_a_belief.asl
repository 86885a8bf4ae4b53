// .wait for a formula goes on as soon as it holds, for an event when that happens.
!start. !other.
+!start <- .wait(ready(X)); .print("ready ", X); .wait({+done(Y)}); .print("done ", Y).
+!other <- .wait(10); +ready(1); .wait(10); +done(2).
// expect: ready 1
// expect: done 2
