// What error_msg(M) says of goals without a plan, of tests (as they are written) and of variables.
!go.
+!go <- !t(1); !t(2); !t(3); !t(4); !t(5).
+!t(1) <- !missing(1).
+!t(2) <- !inapplicable.
+!t(3) <- X = 3; ?unknown(X, Y).
+!t(4) <- !X.
+!t(5) <- X = 5; !X; .print(never).
-!t(4)[error_msg(M)] : .substring(": Variable 'X' must be ground.", M) <- .print("no value").
-!t(5)[error_msg(M)] : .substring(": Variable 'X' must be a Literal and not '5'", M) <- .print("no literal").
-!t(_)[error_msg(M)] <- .print(M).
+!inapplicable : false <- true.
// expect: Found a goal for which there is no relevant plan: +!missing(1)[source(self)]
// expect: Found a goal for which there is no applicable plan: +!inapplicable[source(self)]
// expect: Failed to test 'unknown(X,Y)'
// expect: no value
// expect: no literal
