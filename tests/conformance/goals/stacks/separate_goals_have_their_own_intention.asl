// !!g is pursued beside what posted it, and its failure does not touch that.
!start.
+!start <- !!broken; !!fine; .print("goes on"); .wait(10); .print("ends").
+!broken <- .fail.
+!fine <- .print("fine").
// expect: goes on
// expect: fine
// expect: ends
