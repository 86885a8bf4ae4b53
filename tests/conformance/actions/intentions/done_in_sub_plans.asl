// .done in a sub-plan for a goal ends that goal; in one for an event, or in a goal that this calls,
// the goal around it.
!start.
+!g <- .print(g1); !h; .print(end_g). { +!h <- .print(h); .done; .print(never). }
+!k <- .print(k1); .wait(60); .print(never). { +e(X) <- .print(e,X); !m; .print(never). +!m <- .print(m); .done; .print(never). }
+!q <- .print(q1); .wait(60); .print(never). { +e2(X) <- .print(e,X); .done; .print(never). }
+!w(X) <- !X; .print(after,X).
+!start <- !!w(g); .wait(20); .print("--"); !!w(k); .wait(20); ++e(1); .wait(80); .print("--"); !!w(q); .wait(20); ++e2(2); .wait(80).
// expect: g1
// expect: h
// expect: end_g
// expect: afterg
// expect: --
// expect: k1
// expect: e1
// expect: m
// expect: afterk
// expect: --
// expect: q1
// expect: e2
// expect: afterq
