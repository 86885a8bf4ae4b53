// Lists hold terms of all kinds.
!start.
+!start <- X = [1, "s", f(Y), [], [[]], ~b, a[k]]; Y = 2; .print(X).
// expect: [1,"s",f(2),[],[[]],~b,a[k]]
