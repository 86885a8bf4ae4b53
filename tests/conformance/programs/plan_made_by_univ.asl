// A plan that =.. has made can be added and runs; its context may be in braces.
p(3).
!start.
+!start
  <- P =.. [lab[atomic],{+!h(X)},p(X),{.print("hi ",X); !k}]; .print(P); .add_plan(P); !h(Y); .print(Y);
     Q =.. [two,{+!h2(X)},{p(X) & X > 2},{.print("two ",X)}]; .add_plan(Q); !h2(_);
     R =.. [three,{+!h3},true,{.print("three")}]; .print(R); .add_plan(R); !h3;
     .plan_label(O,old); O =.. [_,T,C,B]; .remove_plan(old); N =.. [new,T,C,B]; .add_plan(N); !old(7).
+!k <- .print("k").
@old +!old(X) : X > 2 <- Y = X+1; .print("old ",Y).
// expect: @lab[atomic] +!h(X) : p(X) <- .print("hi ",X); !k.
// expect: hi 3
// expect: k
// expect: 3
// expect: two 3
// expect: @three +!h3 <- .print("three").
// expect: three
// expect: old 8
