// A belief of a namespace is another one than that of the same name outside.
p(1).
{ begin namespace(m) }
p(2).
q(X) :- p(X).
{ end }
!start.
+!start : p(A) & m::p(B) & m::q(C) & not q(_) <- .print(A, B, C).
// expect: 122
