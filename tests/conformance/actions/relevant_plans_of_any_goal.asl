// {+!_}: the plans for any goal.
!start.
@one +!a(_) : true <- .print(1).
@two[test] +!b.
@three +b.
@four -!a(_).
+!start <- .relevant_plans({+!_}, _, Labels);
           for (.member(L, Labels) & .member(L, [one[source(self)], two[source(self), test],
                                                 three[source(self)], four[source(self)]])) {
             .print(L)
           };
           for (.member(L[test], Labels)) { .print(L) }.
// expect: one[source(self)]
// expect: two[source(self),test]
// expect: two
