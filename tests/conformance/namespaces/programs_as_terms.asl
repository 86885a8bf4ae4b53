// Programs in arguments are terms: nothing in them is of the module. On a side of a relation they are.
{ begin namespace(m) }
!go.
+!go
  <- .print({!g; +b}); .print([{!g}]); C = f({!g}); .print(C);
     B = {!g; ?q(X); +b}; .print(B); E = (a & b); .print(E);
     P = {@l +!g : q(X) <- !h}; .print(P);
     .add_plan({+!g <- .print(added); !h; +b(1)}); !default::g;
     +{@k +!d <- !h}; !d.
+!h <- .print("m h").
{ end }
+!h <- .print("default h").
+b(X) <- .print("default b").
+m::b(X) <- .print("m b").
// expect: { !g; +b }
// expect: [{ !g }]
// expect: f({ !g })
// expect: { !m::g; ?m::q(X); +m::b }
// expect: (m::a & m::b)
// expect: { @l +!m::g : m::q(X) <- !m::h }
// expect: added
// expect: default h
// expect: default b
// expect: m h
