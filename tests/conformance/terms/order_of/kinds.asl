// Numbers before strings before lists before literals before variables.
!start.
+!start
  <- .sort([a, [z], "s", 9, f(1)], L); .print(L);
     if (9 < "a" & "z" < [] & [z] < a & f(1) < X) { .print("in this order") }.
// expect: [9,"s",[z],a,f(1)]
// expect: in this order
