// A variable may stand for an internal action.
!start.
+!start <- A = .print("by a variable"); A.
// expect: by a variable
