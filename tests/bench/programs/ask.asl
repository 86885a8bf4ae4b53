// A context that asks a rule over one fact.
n(100).
at(5).
near(X) :- at(Y) & D = X - Y & D < 3.
!start.
+!start : n(N) <- !each(N).
+!each(0).
+!each(N) : near(7) <- !each(N-1).
