// Only \n and \" are escapes in strings.
!start.
+!start <- .print("a\"b"); .print("c\td"); X = "q"; .print([X]); .length("abc", N); .print(N).
// expect: a"b
// expect: c\td
// expect: ["q"]
// expect: 3
