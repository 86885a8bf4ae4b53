// intBels=newFocus: what a plan believes is an event of its own; the plan does not wait for it.
// agent same
!start.
+!start <- +b; .print(after).
+b <- .print(1); .print(2).
// expect [same]: 1
// expect [same]: 2
// expect [same]: after
// agent new
// settings: intBels=newFocus
!start.
+!start <- +b; .print(after).
+b <- .print(1); .print(2).
// expect [new]: after
// expect [new]: 1
// expect [new]: 2
