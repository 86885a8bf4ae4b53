// The body of a loop may pursue goals and get values from them.
!start.
+!start <- for (.member(X, [2, 3])) { !square(X, Y); .print(Y) }; .print("end").
+!square(X, Y) <- Y = X * X.
// expect: 4
// expect: 9
// expect: end
