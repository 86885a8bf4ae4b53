// What is no string is used as it prints.
!start.
+!start
  <- .reverse(abc, A); .reverse(12.5, B); .reverse(f(x), C); .print(A, " ", B, " ", C);
     .concat(one); .concat([lone]); .concat("a", D); .print(D); .term2string(E, f(g)); .print(E); .term2string(F, 'a b'); .print(F);
     .substring("b", 'abc'); .substring(G, "abcd", 2, end); .print(G); .delete("b", abc, H, unused); .print(H); .delete(a, [a, b], I, unused); .print(I);
     !quoted; !unbound; !mixed.
// The last argument of .concat keeps its quotes.
+!quoted <- .concat("a b", "", 'a b').
-!quoted[error(E)] <- .print(E).
+!unbound <- .substring(Some, "thing").
-!unbound[error(E)] <- .print(E).
+!mixed <- .prefix(["a"], "abc").
-!mixed[error(E)] <- .print(E).
// expect: cba 5.21 )x(f
// expect: a
// expect: f(g)
// expect: 'a b'
// expect: cd
// expect: ac
// expect: [b]
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
