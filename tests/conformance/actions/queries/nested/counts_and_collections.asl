// Queries within queries see what is bound outside, and bind nothing there.
p(a, 1). p(a, 2). p(b, 3).
!start.
+!start
  <- .count(p(a, _), A); .print(A);
     .findall(S, (.member(K2, [a, b]) & .findall(V, p(K2, V), S)), L); .print(L);
     .setof(K3, p(K3, _), Ks); .print(Ks); .print(V).
// expect: 2
// expect: [[1,2],[3]]
// expect: [a,b]
// expect: V<no-value>
