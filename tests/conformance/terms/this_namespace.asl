// this_ns as a term is the namespace of the file; {namespace(n,local)} without begin only declares n.
!start.
+!start
  <- .include("module.asl", hall); .include("module.asl", yard); .print(this_ns);
     !hall::who(H); .print(H); !yard::who(Y); .print(Y).
// expect: default
// expect: asked in hall
// expect: known in hall
// expect: hall
// expect: asked in yard
// expect: known in yard
// expect: yard
// file module.asl
{ namespace(priv,local) }
+!who(N) <- N = this_ns; !priv::secret(this_ns).
{ begin namespace(priv) }
+!secret(N) <- .print("asked in ", N); +N::known.
{ end }
+known <- .print("known in ", this_ns).
