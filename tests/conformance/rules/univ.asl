// =.. takes a literal apart and makes one.
!start.
+!start <- p(1, a)[k] =.. [F, A, An]; .print(F, A, An); X =.. [q, [2], []]; .print(X).
// expect: p[1,a][k]
// expect: q(2)
