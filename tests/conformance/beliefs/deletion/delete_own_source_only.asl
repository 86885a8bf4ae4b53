// -b takes away the source self; a belief with another source stays.
b(1)[source(bob)].
!start.
+!start <- +b(1); -b(1); ?b(1)[source(S)]; .print(S).
// expect: bob
