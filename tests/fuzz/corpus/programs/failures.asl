// Failure at every place where it can happen.
!a(1). !b. !c. !d. !e.
+!a(X) : X < 3 <- !missing(X); .print(never).
-!missing(X)[error(E), error_msg(M), code(C), code_line(L)] <- .print(E, M, C, L); !a(X + 1).
+!a(X) <- ?nothing(X).
-!a(X) : X > 5 <- .print(never).
+!b <- X = {.fail(oops(1))}; X; .print(never).
-!b[oops(N)] <- .print(N); act(N).
+!c <- +x(1); .print(after).
+x(_) <- 1 > 2.
-!c <- .drop_intention(c).
+!d <- (.fail; .print(1)) ||| (.print(2); .wait(3)) ; .print(3).
+!e <- (!f |&| !g(X)); .print(X).
+!f <- .fail.
+!g(1).
-!e <- X; Y; -+Z.
