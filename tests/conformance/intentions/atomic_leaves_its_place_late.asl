// After an atomic plan has ended, its intention makes one more step before the others.
!start.
+!start <- !!o1; !!o2; !!a.
+!o1 <- .print(o1a); .print(o1b); .print(o1c); .print(o1d); .print(o1e).
+!o2 <- .print(o2a); .print(o2b); .print(o2c); .print(o2d); .print(o2e).
+!a <- .print(a1); !at; .print(a2); .print(a3).
@x[atomic] +!at <- .print(at1); !!ev; +bb; .print(at2).
+bb <- .print(bb).
+!ev <- .print(ev).
// expect: o1a
// expect: o2a
// expect: o1b
// expect: a1
// expect: o2b
// expect: o1c
// expect: at1
// expect: bb
// expect: at2
// expect: a2
// expect: o2c
// expect: o1d
// expect: a3
// expect: ev
// expect: o2d
// expect: o1e
// expect: o2e
