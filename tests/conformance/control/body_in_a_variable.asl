// A variable may stand for a whole plan body; its formulas see the plan's variables.
!start.
+!start <- X = 1; B = { .print(X); .print("second") }; B; .print("end").
// expect: 1
// expect: second
// expect: end
