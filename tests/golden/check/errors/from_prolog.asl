// What somebody writes who comes from Prolog.
sum(X, Y, Z) :- Z is X + Y.
both :- at(1, 2), grid(3, 4).
none :- \+ at(1, 2).
less(X, Y) :- X =< Y.
unequal(X, Y) :- X =\= Y.
+!go : at(X, Y), X != Y <- move(left), stay.
+!go -> stay.
