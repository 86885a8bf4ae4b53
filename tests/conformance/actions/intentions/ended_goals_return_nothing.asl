// A goal that is ended from outside, or by .done, returns no values.
!start.
+!start <- !!w; .wait(20); .succeed_goal(g(_)); .wait(20); !!w2; .wait(20); !!w3; .wait(20); .fail_goal(f(_)).
+!w <- !g(X); .print("w ",X).
+!g(X) <- X = 1; .wait(1000).
+!w2 <- !h(X); .print("w2 ",X).
+!h(X) <- X = 1; .done.
+!w3 <- !f(X); .print("w3 ",X).
+!f(X) <- X = 1; .wait(1000).
-!f(X) : not .ground(X) <- .print(failed); X = 2.
// expect: w X<no-value>
// expect: w2 X<no-value>
// expect: failed
// expect: w3 X<no-value>
