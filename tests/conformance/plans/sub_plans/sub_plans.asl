// Plans within a plan serve its own goals and see its variables.
!start.
+!start <- !work(3); !outer.
+!work(X) <- !part; .print("done").
{
  +!part <- .print("part of ", X).
}
+!outer <- !part.
-!outer[error(E)] <- .print(E).
// expect: part of 3
// expect: done
// expect: no_relevant
