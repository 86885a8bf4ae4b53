// A for runs once for each solution, in order.
b(1). b(2). b(3).
!start.
+!start <- for (b(X) & X \== 2) { .print(X) }; .print("end").
// expect: 1
// expect: 3
// expect: end
