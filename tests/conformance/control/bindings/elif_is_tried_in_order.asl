// The first condition that holds decides; its bindings are kept.
p(5).
!start.
+!start
  <- if (p(X) & X > 9) { .print("large") } elif (p(X) & X > 3) { .print("middle") } elif (p(X)) { .print("small") }
     else { .print("none") };
     .print(X).
// expect: middle
// expect: 5
