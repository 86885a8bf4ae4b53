// What is no string is used as it prints, but not reversed.
!start.
+!start
  <- .reverse("abc", A); .print(A); !reversed(abc); !reversed(12.5); !reversed(f(x));
     .concat(one); .concat([lone]); .concat("a", D); .print(D); .term2string(E, f(g)); .print(E); .term2string(F, 'a b'); .print(F);
     .substring("b", 'abc'); .substring(G, "abcd", 2, end); .print(G); .delete("b", abc, H, unused); .print(H); .delete(a, [a, b], I, unused); .print(I);
     !quoted; !unbound; !mixed.
+!reversed(X) <- .reverse(X, _).
-!reversed(_)[error(E), error_msg(M)] <- .print(E, ": ", M).
// The last argument of .concat keeps its quotes.
+!quoted <- .concat("a b", "", 'a b').
-!quoted[error(E)] <- .print(E).
+!unbound <- .substring(Some, "thing").
-!unbound[error(E)] <- .print(E).
+!mixed <- .prefix(["a"], "abc").
-!mixed[error(E)] <- .print(E).
// expect: cba
// expect: wrong_arguments: Wrong argument for internal action 'reverse': first argument of .reverse 'abc' must be a string or a list
// expect: wrong_arguments: Wrong argument for internal action 'reverse': first argument of .reverse '12.5' must be a string or a list
// expect: wrong_arguments: Wrong argument for internal action 'reverse': first argument of .reverse 'f(x)' must be a string or a list
// expect: a
// expect: f(g)
// expect: 'a b'
// expect: cd
// expect: ac
// expect: [b]
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
