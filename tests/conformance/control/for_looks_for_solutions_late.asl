// The solutions of a for are looked for as rounds need them: what a round changes is seen by what
// comes behind the first literal, but not by the literal that is being gone through.
p(1). p(2). p(3). p(4).
!start.
+!start <- for (p(X) & not q(X)) { +q(X+1); .print("a",X) }; .abolish(q(_));
   for (.member(X,[1,2,3,4]) & not q(X)) { +q(X+1); .print("b",X) }; .abolish(q(_));
   for (p(X) & X > 1 & r(Y)) { +r(X); .print(never) };
   for (p(X) & .print("t",X)) { .print("c",X) };
   for (p(X)) { if (X < 20) { +p(X+10) }; .print("d",X) }; .abolish(p(11)); .abolish(p(12)); .abolish(p(13)); .abolish(p(14));
   for (p(X)) { -p(X+1); .print("e",X) }.
// expect: a1
// expect: a3
// expect: b1
// expect: b3
// expect: t1
// expect: c1
// expect: t2
// expect: c2
// expect: t3
// expect: c3
// expect: t4
// expect: c4
// expect: d1
// expect: d2
// expect: d3
// expect: d4
// expect: e1
// expect: e2
// expect: e3
// expect: e4
