:- dynamic edge/2.
two(X, Z) :- edge(X, Y), edge(Y, Z).
run(N) :-
    forall(between(1, N, I), (J is I+1, assertz(edge(I, J)))),
    aggregate_all(count, two(_, _), C),
    print(C), nl.
