// The first condition that holds decides.
!start.
+!start <- !sign(-2); !sign(0); !sign(5).
+!sign(X) <- if (X < 0) { .print("negative") } elif (X == 0) { .print("zero") } else { .print("positive") }.
// expect: negative
// expect: zero
// expect: positive
