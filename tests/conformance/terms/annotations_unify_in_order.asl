// Annotations are compared in their order, each from where the one before was found; only a variable
// starts from the first again. What is left over goes to the tail, with the other's tail.
b[source(alice), source(bob)].
!go.
+!go
  <- if (p[s(X), s(b)] = p[s(a), s(b)]) { .print(found) } else { .print(none) };
     if (p[s(X1), s(a)] = p[s(a), s(b)]) { .print(X1) } else { .print(none) };
     if (b[source(bob), source(S)]) { .print(S) } else { .print(none) };
     if (b[source(alice), source(S2)]) { .print(S2) } else { .print(none) };
     if (p[V, b] = p[a, b]) { .print(V) };
     p[a|T] = p[a, b|R]; .print(T);
     p[a, b] = p[a, b, c|Q]; .print(Q);
     p[a, d] = p[b|M]; .print(M).
// expect: none
// expect: b
// expect: none
// expect: bob
// expect: a
// expect: [b|R]
// expect: Q<no-value>
// expect: [a,d]
