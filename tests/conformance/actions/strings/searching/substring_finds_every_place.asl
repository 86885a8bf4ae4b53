// .substring with an open start looks at each place in turn; the end is that of its last character.
!start.
+!start
  <- .findall(S, .substring("an", "banana", S), L); .print(L);
     .findall(at(S, E), .substring("na", "banana", S, E), M); .print(M);
     .substring(P, "banana", 2); .print(P); .substring(Q, "banana", 1, 3); .print(Q).
// expect: [1,3]
// expect: [at(2,3),at(4,5)]
// expect: nana
// expect: an
