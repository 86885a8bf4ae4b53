// Heads, tails and open lists.
!start.
+!start <- [H|T] = [1, 2, 3]; .print(H, T); [A, B|C] = [1, 2]; .print(A, B, C); X = [0|T]; .print(X); [|Z] = [9]; .print(Z).
// expect: 1[2,3]
// expect: 12[]
// expect: [0,2,3]
// expect: [9]
