// Numbers of .range are gone through one by one: with what stands before and behind it, in steps
// down, to the end although a plan that a round calls has a loop of its own, and from the start
// each time that a loop is entered.
n(2). n(1).
!main.
+!main
  <- for (n(N) & .range(I, 1, N) & .range(J, I, N)) { .print(N, " ", I, " ", J) };
     for (.range(I, 6, 1, -2)) { !below(I) };
     for (.range(A, 1, 2)) { for (.range(B, 1, 2)) { .print(A + B) } };
     for (.range(I, 3, 2)) { .print(never) };
     X = Y;
     for (.range(X, 7, 8)) { .print(Y) };
     for (.range(_, 1, 2)) { .print(again) }.
+!below(J) <- for (.range(I, J, J)) { .print(down(I)) }.
// expect: 2 1 1
// expect: 2 1 2
// expect: 2 2 2
// expect: 1 1 1
// expect: down(6)
// expect: down(4)
// expect: down(2)
// expect: 2
// expect: 3
// expect: 3
// expect: 4
// expect: 7
// expect: 8
// expect: again
// expect: again
