// Goals and plans within a namespace are its own; its terms are everybody's.
!m::start.
!start.
+!start <- .print("outside").
{ begin namespace(m) }
+!start <- +seen(here); .print("inside"); default::say.
-!start[error(E)] <- .print(E); ?seen(X); .print(X).
{ end }
// expect: outside
// expect: inside
// expect: action_failed
// expect: here
