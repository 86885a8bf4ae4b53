// A variable that was open before a loop is open again after a round, in branches as well.
!start.
+!start <- L = f(X, Y);
  for (.member(X, [1, 2])) { Y = X * 10; (.print(a, L)) |&| (.print(b, Y)) };
  .print(L).
// expect: af(1,10)
// expect: b10
// expect: af(2,20)
// expect: b20
// expect: f(X,Y)
