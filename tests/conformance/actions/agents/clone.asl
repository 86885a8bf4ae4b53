// .clone: another agent with the same beliefs and plans.
p(1).
!start.
+!start <- .my_name(agent); .clone(twin); .wait(50); .send(twin, askOne, p(_), A); p(X) = A; .print(X); .all_names(L); .print(L).
// expect: 1
// expect: [agent,twin]
