// number < string < list < literal; functor before arguments.
!start.
+!start <- .sort([b, f(2), [1], "s", 10, f(1, 0), a, 2, ~b, f], L); .print(L).
// expect: [2,10,"s",[1],a,b,~b,f,f(1,0),f(2)]
