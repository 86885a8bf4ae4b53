// .delete: elements that unify, an index, a range of indices; of strings what a regular expression
// matches, a place or a range.
!start.
+!start
  <- .delete(a, [a, b, c, a], L); .print(L); .delete(0, [a, b, c, a], I); .print(I); .delete(1, 3, [a, b, c, a], R); .print(R);
     .delete("a", "banana", S); .print(S); .delete(0, "banana", T); .print(T); .delete(1, 3, "banana", U); .print(U);
     .delete("[an]+", "banana", X); .print(X); .delete(z, [a], A); .print(A); .delete(a, [], E); .print(E); .delete(7, [a], B); .print(B);
     .delete(9, "ab", C); .print(C); .delete("b", abc, D); .print(D); !failure; !wrong.
+!failure <- .delete(a, [a, b], [a]); .print("never").
-!failure[error(E)] <- .print(E).
+!wrong <- .delete(a, b, _); .print("never").
-!wrong[error(E)] <- .print(E).
// expect: [b,c]
// expect: [b,c,a]
// expect: [a,a]
// expect: bnn
// expect: anana
// expect: bana
// expect: b
// expect: [a]
// expect: []
// expect: [a]
// expect: ab
// expect: ac
// expect: ia_failed
// expect: internal_action
