// Numbers by value, strings by their text.
!start.
+!start <- .sort([10, 9, -1, 2.5], N); .print(N); .sort(["b", "B", "ab", "a", ""], S); .print(S).
// expect: [-1,2.5,9,10]
// expect: ["","B","a","ab","b"]
