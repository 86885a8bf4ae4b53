// An external event goes to the root's plan first, then to the sub-plans, which see what the plan's
// variables are now.
!start.
+!start <- !!g(1); .wait(20); ++e; .print(m1); .print(m2); .print(m3); .print(m4).
+!g(Y) <- Z = 7; .wait(60); .print(end_g). { +e <- .print(inner1, Y, Z); .print(inner2). }
+e <- .print(root1); .print(root2).
// expect: m1
// expect: root1
// expect: m2
// expect: inner117
// expect: root2
// expect: m3
// expect: inner2
// expect: m4
// expect: end_g
