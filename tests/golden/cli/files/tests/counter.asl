// A counter, the program under test.
count(0).
+!increment : count(N) <- -+count(N + 1).
+!increment_by(N) <- for (.range(_, 1, N)) { !increment }.
