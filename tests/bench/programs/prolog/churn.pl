:- dynamic item/3.
run(N) :- fill(100000), churn(N).
fill(0) :- !.
fill(I) :- asserta(item(I, old, [weight(I), source(self)])), J is I-1, fill(J).
churn(0) :- !.
churn(I) :-
    asserta(item(I, new, [weight(I), source(self)])),
    retract(item(I, new, [weight(I), source(self)])),
    J is I-1,
    churn(J).
