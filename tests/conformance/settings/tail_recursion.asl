// tro=false: goals that are called last stay on the stack; else a call of the same goal takes the caller's place.
// agent replaces
!start.
+!start <- !count(5); .print(back).
+!count(N) : N > 0 <- !count(N - 1).
+!count(0) <- .intention(_, _, Stack, current); .length(Stack, L); .print(L).
// expect [replaces]: 2
// expect [replaces]: back
// agent keeps
// settings: tro=false
!start.
+!start <- !count(5); .print(back).
+!count(N) : N > 0 <- !count(N - 1).
+!count(0) <- .intention(_, _, Stack, current); .length(Stack, L); .print(L).
// expect [keeps]: 7
// expect [keeps]: back
