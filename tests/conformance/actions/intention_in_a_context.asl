// In a context `current` is the intention that waits for the plan.
caller(Goal, Formula) :- .intention(_, _, [im(_, {+!Goal[_|_]}, {Formula; _}, _)|_], current).
!start.
+!start <- !ask(1); !ask(2).
+!ask(_) : caller(Goal, Formula) <- .print(Goal, " executes ", Formula).
// expect: start executes !ask(1)
// expect: start executes !ask(2)
