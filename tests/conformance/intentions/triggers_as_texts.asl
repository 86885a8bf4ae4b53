// `.wait`, `.at` and `.signal` take triggers as texts, too; their variables are the plan's.
!go.
+!go
  <- Me = self;
     !!later;
     .wait("+price(Me, X)[unit(U)]");
     .print(X, " ", U);
     .wait("+!never", 50, T);
     .print(T);
     .concat("+!contract(", 7, ")", Event);
     .at("now +1 s", Event);
     .signal("+alarm").
+!later <- +price(other, 1)[unit(eur)]; .wait(10); +price(self, 2)[unit(usd)].
+!contract(N) <- .print(contract, N); .wait("no trigger").
-!contract(_)[error(E)] <- .print(E).
+alarm <- .print(alarm).
// expect: 2 usd
// expect: 50
// expect: alarm
// expect: contract7
// expect: unknown
