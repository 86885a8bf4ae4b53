// For the transcript of `jaywalk repl`.
likes(ann, chess).
likes(bob, go).
friends(X, Y) :- likes(X, G) & likes(Y, G) & X \== Y.
!hello.
+!hello <- .print("hello").
+!count(N) : N > 0 <- .print(N); !count(N - 1).
+!count(0) <- .print(done).
+likes(P, G) <- .print(P, " likes ", G).
+!forever <- !forever.
