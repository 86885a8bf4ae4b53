// Values come back in structures and lists.
!start.
+!start <- !split([1, 2, 3], H, T); !make(f(A, g(B))); .print(H, T, A, B).
+!split([X|Y], X, Y).
+!make(f(1, g(2))).
// expect: 1[2,3]12
