// The tests of types: literals are neither numbers, strings, lists nor variables.
!start.
+!start
  <- !all(a); !all(f(1)); !all(~a); !all(a[b]); !all([1]); !all([]); !all("s"); !all(3); !all({ +b });
     if (not .ground(X) & not .literal(X) & not .atom(X) & not .ground(f(X))) { .print("free") }; !failure.
+!failure <- .ground(Free); .print("never").
-!failure[error(E)] <- .print(E).
+!all(T)
  <- .findall(N, .member(N, [atom, literal, number, string, list, ground]) & is(N, T), L); .print(T, " ", L).
is(atom, T) :- .atom(T).
is(literal, T) :- .literal(T).
is(number, T) :- .number(T).
is(string, T) :- .string(T).
is(list, T) :- .list(T).
is(ground, T) :- .ground(T).
// expect: a [atom,literal,ground]
// expect: f(1) [literal,ground]
// expect: ~a [literal,ground]
// expect: a[b] [literal,ground]
// expect: [1] [list,ground]
// expect: [] [list,ground]
// expect: s [string,ground]
// expect: 3 [number,ground]
// expect: { +b } [literal,ground]
// expect: free
// expect: ia_failed
