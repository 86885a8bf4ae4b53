// {+!_}: the plans for any goal.
!start.
@one +!a(_) : true <- .print(1).
@two[test] +!b.
@three +b.
@four -!a(_).
+!start <- .relevant_plans({+!_}, _, Labels);
           for (.member(L, Labels) & .member(L, [one[source(self)|_], two[source(self), test|_],
                                                 three[source(self)|_], four[source(self)|_]])) {
             .print(L)
           };
           for (.member(L[test], Labels)) { .print(L) }.
// expect: one[source(self),url("file:agent.asl")]
// expect: two[source(self),test,url("file:agent.asl")]
// expect: two
