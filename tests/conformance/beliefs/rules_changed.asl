// A rule goes like a belief: the first one of the same head, whatever its body, a belief or a rule.
// `-+` takes the first one of the same name. Neither is an event.
p(1). p(2). f(1). f(2). f(3)[source(bob)]. x(7). x(8).
own(X) :- p(X).
!go.
+!go
  <- Q = {w(X) :- p(X)}; -Q; !all(w); +Q; +Q; !all(w); -Q; !all(w); --Q; !all(w);
     +{g(1) :- p(1)}; +{g(1) :- p(2)}; -{g(1) :- p(3)}; .relevant_rules(g(_), L); .print(L);
     -g(1); !all(g); -{g(1) :- false}; !all(g);
     -{f(X) :- p(X)}; !all(f); -{f(2) :- p(_)}; !all(f); -{f(_) :- true}; !all(f); .print(X);
     +{h(X)[k] :- p(X)}; -{h(X)[l] :- p(X)}; !all(h); -{h(X)[k] :- p(X)}; !all(h);
     +{s(X)[source(bob)] :- p(X)}; -{s(X) :- p(X)}; !all(s); -{s(X)[source(_)] :- p(X)}; !all(s);
     -+{x(X) :- p(X)}; !all(x); -+{x(X) :- p(X) & X > 1}; !all(x); R = {x(5) :- true}; -+R; !all(x);
     -+x(6); !all(x);
     !context; -{own(_) :- true}; !context; +{own(9) :- true}; !context; -own(_); !context;
     -{unknown(_) :- true}; G = {goal(4) :- p(1)}; !G; !!G; .wait(10).
+!all(P) <- T =.. [P,[X],[]]; .findall(X, T, L); .print(P, L).
+!context : own(X) <- .print("context ", X).
+!context <- .print("no context").
+!goal(X) <- .print("goal ", X).
+f(X) : X > 3 <- .print("event").
-f(_) <- .print("event").
+x(X) : X < 7 <- .print("event +x(", X, ")").
-x(X) <- .print("event -x(", X, ")").
// expect: w[]
// expect: w[1,2,1,2]
// expect: w[1,2]
// expect: w[]
// expect: [{ g(1) :- p(1) }]
// expect: g[1]
// expect: g[]
// expect: f[2,3]
// expect: f[3]
// expect: f[3]
// expect: X<no-value>
// expect: h[1,2]
// expect: h[]
// expect: s[1,2]
// expect: s[]
// expect: x[1,2,8]
// expect: x[2,8]
// expect: x[5,8]
// expect: event -x(5)
// expect: event +x(6)
// expect: x[6,8]
// expect: context 1
// expect: no context
// expect: context 9
// expect: no context
// expect: goal 4
// expect: goal 4
