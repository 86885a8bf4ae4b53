// A sub-plan sees the variables of all plans around it, as they were when those began; what it
// binds itself stays its own.
!start.
+!start <- !a(1); !d(Y); !e(2).
+!a(X) <- !b. { +!b <- !c. { +!c <- .print(X). } }
+!d(X) <- X = 5; !late. { +!late : X == 5 <- .print("bound"). +!late <- .print("open"). }
+!e(X) <- Z = 7; !once; !once. { +!once <- .print(X); Z = 8; .print(Z). }
// expect: 1
// expect: open
// expect: 2
// expect: 8
// expect: 2
// expect: 8
