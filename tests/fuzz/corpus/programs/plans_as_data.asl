// Programs as data: bodies, triggers, plans and rules in terms.
!start.
+!start <-
  B = { .print(one); !two(X); +three };
  .print(B); B;
  P = { @l[atomic, k(1)] +!four(Y) : three & Y > 1 <- .print(Y); Z = Y * 2 };
  .add_plan(P); !four(3);
  +{ five(Q) :- three & Q = 5 }; ?five(R); .print(R);
  T = { +!four(_) }; .print(T);
  .relevant_plans({ +!two(_) }, L); .print(L);
  P =.. [Lab, Tr, C, Bo]; .print(Lab, Tr, C, Bo);
  { !G; Rest } = { !two(7); .print(x) }; !G; Rest;
  .term2string(TT, "f(X,[1|Y])[a]"); .print(TT).
+!two(X) <- X = 2; .print(two).
-!start[error(E)] <- .print(E).
