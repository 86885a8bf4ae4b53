// Conditions of if, while and for are of the module, as contexts are; queries of .findall are terms.
{ begin namespace(m) }
q(1). p(2).
!go.
+!go : q(1)
  <- if (q(X)) { .print("yes ",X) } else { .print(no) };
     while (p(K) & K > 0) { .print(K); -+p(K-1) };
     for (q(Z)) { .print("for ",Z) };
     if (not q(9) & q(W) & W == 1) { .print(both) };
     .findall(A,q(A),L); .print(L); .findall(A,m::q(A),M); .print(M);
     { !a } |&| { !b }; .print(joined).
+!a <- .print("m a").
+!b <- .print("m b").
{ end }
// expect: yes 1
// expect: 2
// expect: 1
// expect: for 1
// expect: both
// expect: []
// expect: [1]
// expect: m a
// expect: m b
// expect: joined
