// Naive reverse of a list of 30 by rules, 496 inferences a round.
n(10).
append([], L, L).
append([H|T], L, [H|R]) :- append(T, L, R).
reverse([], []).
reverse([H|T], R) :- reverse(T, S) & append(S, [H], R).
!start.
+!start : n(N) <- !loop(N).
+!loop(0).
+!loop(N)
  : reverse([1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30], _)
  <- !loop(N-1).
