// Programs and formulas have a place in the order of terms: by the functor that they have in Jason.
!start.
+!start
  <- .sort([b,{!g},a,{+!t},{@l +!p <- x},{h:-b},zz,achieve,te,plan,te(1),{?q},{a},action,{},none,f(1)],L);
     for (.member(X,L)) { .print(X) };
     .sort([b,(a&b),a,(a|b),(not a),(x>1),(x<1),(x==1),{!g}],M); .print(M);
     .sort([{!b},{!a;!c},{!a},{?a},{!a;!b}],N); .print(N);
     .union([{!a},{!b}],[{!b},{!a}],O); .print(O).
// expect: a
// expect: achieve
// expect: { !g }
// expect: action
// expect: { a }
// expect: b
// expect: f(1)
// expect: { h :- b }
// expect: { }
// expect: none
// expect: plan
// expect: { @l +!p <- x }
// expect: te
// expect: te(1)
// expect: { +!t }
// expect: { ?q }
// expect: zz
// expect: [(a & b),(x < 1),(x == 1),(x > 1),(a | b),a,{ !g },b,not (a)]
// expect: [{ !a },{ !a; !b },{ !a; !c },{ !b },{ ?a }]
// expect: [{ !a },{ !b }]
