run(0) :- !.
run(N) :-
    aggregate_all(count, place([1,2,3,4,5,6,7,8], [], _), C), C =:= 92,
    M is N-1,
    run(M).
sel(X, [X|T], T).
sel(X, [H|T], [H|R]) :- sel(X, T, R).
safe(_, _, []).
safe(Q, D, [P|Ps]) :- Q =\= P + D, Q =\= P - D, D1 is D + 1, safe(Q, D1, Ps).
place([], Placed, Placed).
place(Free, Placed, Queens) :- sel(Q, Free, Rest), safe(Q, 1, Placed), place(Rest, [Q|Placed], Queens).
