// A file that is included for a variable has a new namespace, wherever the directive stands.
!go.
+!go
  <- .include("counter.asl", N); .include("outer.asl", o); .include("outer.asl", o);
     !N::inc; .findall(X, K::n(X), L); .sort(L, S); .print(S).
// file counter.asl
n(0).
+!inc <- -+n(7).
// file outer.asl
{ include("counter.asl", _) }
// expect: [0,0,7]
