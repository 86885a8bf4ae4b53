// Each `.include` has local namespaces of its own: two counters do not count together. Without a
// namespace the file is included into the module that asks. What is included anew into the same
// namespace comes behind what is there.
!go.
+!go
  <- .include("counter.asl", c1); .include("counter.asl", c2);
     !c1::inc; !c1::inc; !c2::inc; !c1::show; !c2::show;
     .include("counter.asl", N); .include("counter.asl", M); !N::inc; !N::show; !M::show;
     .include("counter.asl", c1); !c1::inc; !c1::show;
     .findall(X, priv::n(X), L); .print(L); !m::go; !show.
{ begin namespace(m) }
+!go <- .include("counter.asl"); !inc; !show.
{ end }
+!show <- .print("not here").
// file counter.asl
{ namespace(priv, local) }
priv::n(0).
+!inc <- ?priv::n(X); -+priv::n(X+1).
{ begin namespace(priv) }
+!value(X) <- ?n(X).
{ end }
+!show <- !priv::value(X); .print(this_ns, " ", X).
// expect: c1 2
// expect: c2 1
// expect: ns1 1
// expect: ns2 0
// expect: c1 3
// expect: []
// expect: m 1
// expect: not here
