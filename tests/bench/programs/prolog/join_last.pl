:- dynamic edge/3.
two(X, Z) :- edge(X, _, Y), edge(Z, _, X), Y > Z.
run(N) :-
    forall(between(1, N, I), (J is I+1, assertz(edge(I, road, J)))),
    aggregate_all(count, two(_, _), C),
    print(C), nl.
