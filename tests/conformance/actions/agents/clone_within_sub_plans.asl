// .clone: the twin goes on in sub-plans, with the variables of the plans around them.
!outer(1).
!copy.
+!outer(X) <- !middle(2); .print("outer ", X). {
  +!middle(Y) <- +a; !inner; .print("middle ", X, Y). { +!inner <- +b; +c; +d; .print("inner ", X, Y). }
}
+!copy <- -+ready; .clone(twin).
// expect: inner 12
// expect: middle 12
// expect: outer 1
// expect [twin]: inner 12
// expect [twin]: middle 12
// expect [twin]: outer 1
