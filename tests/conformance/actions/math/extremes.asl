// math.max and math.min, of two numbers or of those in a list; of no numbers, Jason's start values.
!start.
+!start
  <- .print(math.max(3, 7), " ", math.min(3, 7), " ", math.max(-1, -1)); .print(math.max([3, a, 9, "s"]), " ", math.min([3, a, 9, 2]));
     X = -1; .print(math.max(X, -2), " ", math.min([X])); .print(math.max(2, Y));
     if (math.max([]) > 0 & math.max([a]) < 1.0E-300) { .print("tiny ", math.min(["s"])) };
     .print(math.max([-3, -2])).
// expect: 7 3 -1
// expect: 9 2
// expect: -1 -1
// expect: math.max(2,Y)
// expect: tiny 1.7976931348623157E308
// expect: -2
