// Arguments are separated by commas without blanks; annotations are in order.
!start.
+!start
  <- .print(f(a, B, "s", 1)); .print(~f(a)); .print(g[z, a, m(2)]); .print(f(g(h), [])[k]); .print([]);
     .print([a, b | T]); .print([1, [2, [3]]]); .print(n::f(a)).
// expect: f(a,B,"s",1)
// expect: ~f(a)
// expect: g[a,m(2),z]
// expect: f(g(h),[])[k]
// expect: []
// expect: [a,b|T]
// expect: [1,[2,[3]]]
// expect: n::f(a)
