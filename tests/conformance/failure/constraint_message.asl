// A constraint that fails says what was left to do, where, and what the variables were.
!go.
short(L) :- length(L, N) & N < 9.
length(road, 5).
+!go <- !a; !b; !c(1); !d(road).
+!a <- X = 1; X > 3; .print(never).
-!a[error_msg(M),code(C)] <- .print(M,"; ",C).
+!b <- if (true) { Y = f(Z); Y == "x" }; .print(never).
-!b[error_msg(M)] <- .print(M).
+!c(K) <- K = 2.
-!c(_)[error_msg(M)] <- .print(M).
// The variables of a rule that the context asks are not the plan's.
+!d(L) : short(L) <- L = lane.
-!d(_)[error_msg(M)] <- .print(M).
// expect: Constraint (X > 3); .print(never) was not satisfied (file:agent.asl:6) un={X=1}; (1 > 3)
// expect: Constraint (Y == "x"); .print(never) was not satisfied (file:agent.asl:8) un={Y=f(Z)}
// expect: Constraint (K = 2) was not satisfied (file:agent.asl:10) un={K=1}
// expect: Constraint (L = lane) was not satisfied (file:agent.asl:13) un={L=road}
