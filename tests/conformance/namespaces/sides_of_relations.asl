// A literal on a side of a relation is a term, even with the module's own prefix; others keep theirs.
{ begin namespace(m) }
!go.
+!go
  <- X = p(1); .print(X); Y = m::p(1); .print(Y); if (X == p(1) & X == m::p(1)) { .print(equal) };
     V = ::p; .print(V); W = default::p; .print(W); !n.
+!n <- K = n::z; .print(K).
-!n[error(E)] <- .print(E).
{ end }
// expect: p(1)
// expect: p(1)
// expect: equal
// expect: p
// expect: p
// expect: constraint_failed
