// .clone: the twin goes on in all branches of a fork of the original, and joins them by itself.
!both.
!either.
!copy.
+!both <- (!left |&| !right); .findall(A, done(A), As); .sort(As, Sorted); .print("both ", Sorted).
+!left <- +a; +b; +c; +done(left).
+!right <- +d; +done(right).
+!either <- (!long ||| !short); .print("either").
+!long <- +e; +f; +g; +h; +i; +j; .print("never").
+!short <- +k; +l; +m.
+!copy <- -+ready; .clone(twin).
// expect: either
// expect: both [left,right]
// expect [twin]: either
// expect [twin]: both [left,right]
