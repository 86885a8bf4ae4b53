// events=requeue: an event that no plan is applicable for comes to the end of the queue, until one is;
// the agent is never idle while one waits.
// expect end: limit
// agent keeps
// settings: events=requeue
!start.
+!start <- ++b; .print(1); .print(2); +ready; .print(3); .print(4).
+b : ready <- .print(b).
// expect [keeps]: 1
// expect [keeps]: 2
// expect [keeps]: b
// expect [keeps]: 3
// expect [keeps]: 4
// agent discards
!start.
+!start <- ++b; .print(1); .print(2); +ready; .print(3); .print(4).
+b : ready <- .print(b).
// expect [discards]: 1
// expect [discards]: 2
// expect [discards]: 3
// expect [discards]: 4
