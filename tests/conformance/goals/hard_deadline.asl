// A goal with hard_deadline(Ms) that is still there after that time fails, with the goals that it
// has called; one that was achieved in time, and the same goal called again, do not.
// expect: init
// expect: deadline_reached for g(4)
// expect: done 1
// expect: end
// expect: deadline_reached for g(9)
// expect: deadline_reached for nested
!start.
+!start <- .print(init);
           !!g(9)[hard_deadline(7000)];
           !g(4)[hard_deadline(3000)];
           !g(1)[hard_deadline(2000)];
           .print(end);
           .wait(10000);
           !nested[hard_deadline(2*500)].
+!g(S) <- .wait(S*1000); .print("done ",S).
-!g(S)[error(E)] <- .print(E," for g(",S,")").
+!nested <- !inner(1); .print("never").
+!inner(N) <- .wait(400); !inner(N+1).
-!nested[error(E)] <- .print(E," for nested").
