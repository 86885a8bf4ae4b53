// .substring: whether and where a text occurs; the part between two places; any term counts as its text.
!start.
+!start
  <- .substring("an", "banana"); .findall(P, .substring("an", "banana", P), L); .print(L);
     .findall(f(P, Q), .substring("an", "banana", P, Q), M); .print(M); .substring("nan", "banana", 2);
     .substring(S, "banana", 2); .print(S); .substring(T, "banana", 1, 3); .print(T); .substring("abc", R, 1); .print(R);
     .substring(b(1), a(b(1), c), P1); .print(P1); .findall(P, .substring("x", "banana", P), E); .print(E); !failure.
+!failure <- .substring("x", "banana"); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [1,3]
// expect: [f(1,2),f(3,4)]
// expect: nana
// expect: an
// expect: bc
// expect: 2
// expect: []
// expect: ia_failed
