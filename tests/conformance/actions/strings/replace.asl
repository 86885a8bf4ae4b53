// .replace: all that a regular expression matches.
!start.
+!start
  <- .replace("banana", "a", "o", R); .print(R); .replace("a1b22", "[0-9]+", "#", S); .print(S); .replace("abc", "x", "y", T); .print(T);
     .replace("john smith", "([a-z]+) ([a-z]+)", "$2 $1", G); .print(G); .replace("", "a", "b", E); .length(E, N); .print(N); !failure.
+!failure <- .replace("a", "a", "b", "c"); .print("never").
-!failure[error(E)] <- .print(E).
// expect: bonono
// expect: a#b#
// expect: abc
// expect: smith john
// expect: 0
// expect: ia_failed
