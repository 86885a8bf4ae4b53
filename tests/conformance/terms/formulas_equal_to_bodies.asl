// A literal is equal to the body that stands for it, not the other way round. A trigger has no parts.
!start.
+!start
  <- H = achieve(a); X = {!a}; !equal(H, X); !equal(X, H);
     !equal(test(a), {?a}); !equal(achieve(b), {!a}); !equal(a, {a});
     if (achieve(a) \== {!a}) { .print(differ) } else { .print(same) };
     {+!g} =.. L; .print(L); {+!g(1)[a]} =.. M; .print(M); {!g} =.. N; .print(N).
+!equal(A, B) : A == B <- .print(A, " equals ", B).
+!equal(A, B) <- .print(A, " is not ", B).
// expect: achieve(a) equals { !a }
// expect: { !a } is not achieve(a)
// expect: test(a) equals { ?a }
// expect: achieve(b) is not { !a }
// expect: a is not { a }
// expect: same
// expect: [default,te,[],[]]
// expect: [default,te,[],[]]
// expect: [default,achieve,[g],[]]
