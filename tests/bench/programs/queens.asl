// All 92 ways to place eight queens: backtracking with arithmetic in rules.
n(1).
select(X, [X|T], T).
select(X, [H|T], [H|R]) :- select(X, T, R).
safe(_, _, []).
safe(Q, D, [P|Ps]) :- Q \== P + D & Q \== P - D & safe(Q, D + 1, Ps).
place([], Placed, Placed).
place(Free, Placed, Queens) :- select(Q, Free, Rest) & safe(Q, 1, Placed) & place(Rest, [Q|Placed], Queens).
!start.
+!start : n(N) <- !loop(N).
+!loop(0).
+!loop(N) <- .count(place([1,2,3,4,5,6,7,8], [], _), C); C == 92; !loop(N-1).
