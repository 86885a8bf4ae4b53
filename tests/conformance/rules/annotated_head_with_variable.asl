// A variable in the annotations of a rule's head is the rule's, not the asking plan's.
p(1)[k(X)] :- X = 7.
p(2)[k(X)].
!go(5).
+!go(X) <- for (p(1)[k(K)]) { .print(K) }; .count(p(_)[k(5)],N); ?p(1)[k(Z)]; .print(X," ",N," ",Z).
// expect: 7
// expect: 5 1 7
