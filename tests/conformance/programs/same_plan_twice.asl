// A plan that comes twice with its label is one plan, as when two files include a third.
!start. !start2.
@l +!g(X) : X > 1 <- .print("g ",X).
@l +!g(X) : X > 1 <- .print("g ",X).
+!start <- !g(2); .relevant_plans({+!g(_)},P); .length(P,N); .print(N).
// Labels of sub-plans are their plan's own.
+!start2 <- !a; !b.
+!a <- !s. { @in +!s <- .print("a's"). }
+!b <- !s. { @in +!s <- .print("b's"). }
// expect: g 2
// expect: a's
// expect: 1
// expect: b's
