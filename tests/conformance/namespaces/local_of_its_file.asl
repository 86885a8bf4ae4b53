// A local namespace is its file's alone, and one however often the file begins it.
{ include("counter.asl", c) }
{ begin namespace(own, local) }
first(1).
{ end }
{ begin namespace(own, local) }
+!both <- ?first(X); .print("first ", X).
{ end }
!go.
+!go
  <- !c::show; !own::both;
     if (hidden::n(N)) { .print("seen ", N) } else { .print("hidden") };
     if (own::b(N)) { .print("seen ", N) } else { .print("of another file") }.
// file counter.asl
{ namespace(hidden, local) }
hidden::n(0).
own::b(1).
+!show <- ?hidden::n(N); .print("n ", N); if (own::first(_)) { .print("seen") } else { .print("not seen") }.
// expect: n 0
// expect: not seen
// expect: first 1
// expect: hidden
// expect: of another file
