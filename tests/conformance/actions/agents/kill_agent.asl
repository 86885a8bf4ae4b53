// .kill_agent: it is gone; an unknown one fails; with a deadline it is told before.
// agent ann
!start.
+!start <- .kill_agent(bob); .wait(50); .all_names(L); .print(L); .kill_agent(cid, 100); .wait(500); .all_names(M); .print(M); !failure.
+!failure <- .kill_agent(nobody); .print("never").
-!failure[error(E)] <- .print(E).
// agent bob
+!g <- .print("never").
// agent cid
+jag_shutting_down(T) <- .print("told ", T).
// expect [ann]: [ann,cid]
// expect [ann]: [ann]
// expect [ann]: ia_failed
// expect [cid]: told 100
