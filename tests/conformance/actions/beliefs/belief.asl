// .belief goes through the facts that unify; rules are not asked.
p(1)[a]. p(2). r(X) :- p(X).
!start.
+!start
  <- .findall(X, .belief(p(X)), L); .print(L); .findall(X, .belief(p(X)[a]), A); .print(A);
     .findall(X, .belief(r(X)), R); .print(R); if (.belief(p(9))) { .print("bad") } else { .print("none") }.
// expect: [1,2]
// expect: [1]
// expect: []
// expect: none
