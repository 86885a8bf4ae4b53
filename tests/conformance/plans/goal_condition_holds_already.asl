// A goal whose condition holds when its plan is chosen is achieved without one formula of the plan.
!direct.
!nested.
+!direct <: true <- .print("never").
+!nested <- !sub; .print("after sub").
+!sub <: true <- .print("never").
-!Failed <: true <- .print("never").
!unknown.
// expect: after sub
