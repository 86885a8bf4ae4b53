// A variable as a formula stands for the module's literal.
{ begin namespace(m) }
q(1). t.
!go.
+!go
  <- G = g(1); !G; Q = q(X); ?Q; .print(X); B = b(3); +B; -B; !!G; .wait(20);
     H = .print(internal); H; !c(q(1)); !c(q(2)); !c(true); !c(t);
     F = q(Y); if (F) { .print("if ",Y) }; !r.
+!g(X) <- .print("m g ",X).
+b(X) <- .print("m b ",X).
-b(X) <- .print("m -b ",X).
+!c(F) : F <- .print("holds ",F).
+!c(F) : not F <- .print("not ",F).
h(F) :- F.
+!r : h(q(1)) & not h(q(2)) <- .print(rule).
{ end }
+!g(X) <- .print("default g ",X).
+b(X) <- .print("default b ",X).
// expect: m g 1
// expect: 1
// expect: m b 3
// expect: m -b 3
// expect: m g 1
// expect: internal
// expect: holds q(1)
// expect: not q(2)
// expect: holds true
// expect: holds t
// expect: if 1
// expect: rule
