// The condition of a loop may be a belief that a variable stands for, a rule's answer, too.
r(1).
!a(1).
+!a(X) : Y & r(1) <- for (Y) { .print(done(X)) }.
a[X, d(c)] :- n::a \== math.e.
// expect: done(1)
