// .clone: the twin goes on in the round in which a loop of the original is; its rounds bind anew.
!rounds.
!count(0).
!copy.
+!rounds <- for (.range(X, 1, 4)) { Y = X * 10; +seen(Y) }; .findall(A, seen(A), As); .print(As).
+!count(N) <- +at(N); while (at(M) & M < 5) { -+at(M + 1) }; ?at(L); .print("at ", L).
+!copy <- -+ready; .clone(twin).
// expect: [40,30,20,10]
// expect: at 5
// expect [twin]: [40,30,20,10]
// expect [twin]: at 5
