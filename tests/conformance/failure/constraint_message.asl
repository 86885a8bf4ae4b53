// A constraint that fails says what was left to do, where, and what the variables were.
!go.
+!go <- !a; !b; !c(1).
+!a <- X = 1; X > 3; .print(never).
-!a[error_msg(M),code(C)] <- .print(M,"; ",C).
+!b <- if (true) { Y = f(Z); Y == "x" }; .print(never).
-!b[error_msg(M)] <- .print(M).
+!c(K) <- K = 2.
-!c(_)[error_msg(M)] <- .print(M).
// expect: Constraint (X > 3); .print(never) was not satisfied (file:agent.asl:4) un={X=1}; (1 > 3)
// expect: Constraint (Y == "x"); .print(never) was not satisfied (file:agent.asl:6) un={Y=f(Z)}
// expect: Constraint (K = 2) was not satisfied (file:agent.asl:8) un={K=1}
