// .print writes its arguments one after another: strings bare at the top, quoted within terms; what
// is unbound is said to be so; it never fails.
!start.
+!start <- .print("a ", 1.5, f("b", [c, 2.0]), ~d[e]); .print(X, g(X)); .print(1 / 0, 0.1 + 0.2).
// expect: a 1.5f("b",[c,2])~d[e]
// expect: X<no-value>g(X)
// expect: Infinity0.30000000000000004
