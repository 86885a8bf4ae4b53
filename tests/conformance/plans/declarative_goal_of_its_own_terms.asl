// {begin dg(g)}: each plan for the goal tests what it was called for, in its own variables.
!start.
on(a, table). on(b, table).
tower([X]) :- on(X, table).
tower([X, Y|T]) :- on(X, Y) & tower([Y|T]).
{ begin dg(tower(T)) }
+!tower([X, Y|T]) <- !tower([Y|T]); -on(X, _); +on(X, Y).
+!tower([X]).
+!other <- .print(other).
{ end }
+!start <- !tower([a, b]); .print(built); !other.
// expect: built
// expect: other
