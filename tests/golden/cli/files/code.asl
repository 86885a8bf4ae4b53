// A rule and plans whose code docs/internals/engine.md explains.
near(X) :- at(Y) & D = X - Y & D < 3.
at(4).
!walk(5).
+!walk(0).
+!walk(N) : near(N) & not blocked <- +step(N); !walk(N-1).
