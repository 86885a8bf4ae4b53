// .abolish deletes all that unify, whatever their sources.
b(1). b(2)[source(bob)]. b(3)[k]. c(1).
!start.
+!start <- .abolish(b(_)); .count(b(_), N); .count(c(_), M); .print(N, M).
// expect: 01
