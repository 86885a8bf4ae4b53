// Rounds of a for do not see what earlier ones bound.
p(1). p(2). p(3).
!start.
+!start <- for (p(X)) { Y = X * 10; .print(Y) }; .print(X).
// expect: 10
// expect: 20
// expect: 30
// expect: X<no-value>
