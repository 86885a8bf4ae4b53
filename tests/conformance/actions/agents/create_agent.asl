// .create_agent: without a program it knows nothing; a taken name gets a suffix, a variable the name;
// a file that is not there is an error.
!start.
+!start
  <- .create_agent(empty); .all_names(L); .print(L); .create_agent(Helper); .print(Helper); .create_agent(helper); .all_names(M); .print(M); !run; !failure.
+!run <- .create_agent(worker, "worker.asl"); .wait(50).
+!failure <- .create_agent(lost, "no_such_file.asl"); .print("never").
-!failure[error(E)] <- .print(E).
// file worker.asl
!work.
+!work <- .my_name(N); .print("I am ", N).
// expect: [agent,empty]
// expect: helper
// expect: [agent,empty,helper,helper_1]
// expect [worker]: I am worker
// expect: internal_action
