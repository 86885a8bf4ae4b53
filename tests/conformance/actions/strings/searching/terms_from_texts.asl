// .term2string reads terms of all kinds and writes what it reads.
!start.
+!start
  <- .term2string(A, "f(X, [1, 2], \"s\")[k]"); .print(A); .term2string(B, "3 + 4"); .print(B); .term2string(C, "~p"); .print(C);
     .term2string(f(g, "t"), S); .print(S); .length(S, N); .print(N).
// expect: f(X,[1,2],"s")[k]
// expect: 7
// expect: ~p
// expect: f(g,"t")
// expect: 8
