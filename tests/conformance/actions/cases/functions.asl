// What each arithmetic function does ordinarily, at the boundary, and when it fails: a value that is no
// number, or the term as it stands.
b(1). b(2).
!start.
+!start
  <- for (.member(A, ["math.abs", "math.acos", "math.asin", "math.atan", "math.cos", "math.sin", "math.tan", "math.ceil", "math.floor",
                      "math.round", "math.sqrt", "math.log", "math.e", "math.pi", "math.max", "math.min", "math.sum", "math.average",
                      "math.mean", "math.median", "math.std_dev", "math.random", "length", "count", "system.time"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary("math.abs") <- .print(math.abs(-2), " ", math.abs(2.5)).
+!boundary("math.abs") <- .print(math.abs(0), " ", math.abs(-1 / 0)).
+!failure("math.abs") <- .print(math.abs(X), " ", math.abs(a)).
+!ordinary("math.acos") <- .print(math.acos(0)).
+!boundary("math.acos") <- .print(math.acos(1), " ", math.acos(-1)).
+!failure("math.acos") <- .print(math.acos(1.1)).
+!ordinary("math.asin") <- .print(math.asin(0.5)).
+!boundary("math.asin") <- .print(math.asin(1), " ", math.asin(-1)).
+!failure("math.asin") <- .print(math.asin(-1.1)).
+!ordinary("math.atan") <- .print(math.atan(1)).
+!boundary("math.atan") <- .print(math.atan(0), " ", math.atan(1 / 0)).
+!failure("math.atan") <- .print(math.atan(X)).
+!ordinary("math.cos") <- .print(math.cos(math.pi)).
+!boundary("math.cos") <- .print(math.cos(0)).
+!failure("math.cos") <- .print(math.cos(1 / 0), " ", math.cos(X)).
+!ordinary("math.sin") <- .print(math.sin(math.pi / 2)).
+!boundary("math.sin") <- .print(math.sin(0)).
+!failure("math.sin") <- .print(math.sin(1 / 0), " ", math.sin(X)).
+!ordinary("math.tan") <- .print(math.round(math.tan(math.pi / 4))).
+!boundary("math.tan") <- .print(math.tan(0)).
+!failure("math.tan") <- .print(math.tan(1 / 0), " ", math.tan(X)).
+!ordinary("math.ceil") <- .print(math.ceil(1.1), " ", math.ceil(-1.1)).
+!boundary("math.ceil") <- .print(math.ceil(2), " ", math.ceil(-0.5)).
+!failure("math.ceil") <- .print(math.ceil(X)).
+!ordinary("math.floor") <- .print(math.floor(1.9), " ", math.floor(-1.1)).
+!boundary("math.floor") <- .print(math.floor(2), " ", math.floor(0.5)).
+!failure("math.floor") <- .print(math.floor(X)).
+!ordinary("math.round") <- .print(math.round(1.4), " ", math.round(1.6)).
+!boundary("math.round") <- .print(math.round(2.5), " ", math.round(-2.5)).
+!failure("math.round") <- .print(math.round(0 / 0), " ", math.round(X)).
+!ordinary("math.sqrt") <- .print(math.sqrt(16)).
+!boundary("math.sqrt") <- .print(math.sqrt(0), " ", math.sqrt(2)).
+!failure("math.sqrt") <- .print(math.sqrt(-1)).
+!ordinary("math.log") <- .print(math.log(math.e)).
+!boundary("math.log") <- .print(math.log(1), " ", math.log(0)).
+!failure("math.log") <- .print(math.log(-1)).
+!ordinary("math.e") <- .print(math.e).
+!boundary("math.e") <- .print(math.floor(math.e), " ", math.ceil(math.e)).
+!failure("math.e") <- if (not math.e == 3) { .print("not 3") }.
+!ordinary("math.pi") <- .print(math.pi).
+!boundary("math.pi") <- .print(math.floor(math.pi), " ", math.ceil(math.pi)).
+!failure("math.pi") <- if (not math.pi == 3) { .print("not 3") }.
+!ordinary("math.max") <- .print(math.max(1, 2), " ", math.max([1, 3, 2])).
+!boundary("math.max") <- .print(math.max([]), " ", math.max([a, 2, "3"]), " ", math.max(1, 1)).
+!failure("math.max") <- .print(math.max(1, X)).
+!ordinary("math.min") <- .print(math.min(1, 2), " ", math.min([2, 1, 3])).
+!boundary("math.min") <- .print(math.min([]), " ", math.min([a, 2, "1"]), " ", math.min(1, 1)).
+!failure("math.min") <- .print(math.min(1, X)).
+!ordinary("math.sum") <- .print(math.sum([1, 2, 3.5])).
+!boundary("math.sum") <- .print(math.sum([]), " ", math.sum([a, 1])).
+!failure("math.sum") <- .print(math.sum(a)).
+!ordinary("math.average") <- .print(math.average([1, 2, 6])).
+!boundary("math.average") <- .print(math.average([4]), " ", math.average([a, 1])).
+!failure("math.average") <- .print(math.average([]), " ", math.average(a)).
+!ordinary("math.mean") <- .print(math.mean([1, 2, 6])).
+!boundary("math.mean") <- .print(math.mean([4])).
+!failure("math.mean") <- .print(math.mean([]), " ", math.mean(a)).
+!ordinary("math.median") <- .print(math.median([3, 1, 2])).
+!boundary("math.median") <- .print(math.median([4]), " ", math.median([4, 1, 3, 2])).
+!failure("math.median") <- .print(math.median([]), " ", math.median([a])).
+!ordinary("math.std_dev") <- .print(math.std_dev([1, 2, 3])).
+!boundary("math.std_dev") <- .print(math.std_dev([2, 2]), " ", math.std_dev([1])).
+!failure("math.std_dev") <- .print(math.std_dev(a)).
+!ordinary("math.random") <- X = math.random; if (X >= 0 & X < 1) { .print("up to 1") }; Y = math.random(5); if (Y >= 0 & Y < 5) { .print("up to 5") }.
+!boundary("math.random") <- .print(math.random(0)).
+!failure("math.random") <- .print(math.random(X)).
+!ordinary("length") <- .print(.length([a, b]), " ", .length("abc")).
+!boundary("length") <- .print(.length([]), " ", .length("")).
+!failure("length") <- .print(.length(X), " ", .length(a)).
+!ordinary("count") <- .print(.count(b(_)), " ", .count(b(X) & X > 1)).
+!boundary("count") <- .print(.count(none(_)), " ", .count(true)).
+!failure("count") <- if (not .count(b(_)) == 3) { .print("not 3") }.
+!ordinary("system.time") <- T = system.time; if (T > 0) { .print("a number") }.
+!boundary("system.time") <- S = system.time; T = system.time; if (S <= T) { .print("never back") }.
+!failure("system.time") <- if (not system.time == 0) { .print("since 1970") }.
// expect: 2 2.5
// expect: 0 Infinity
// expect: math.abs(X) math.abs(a)
// expect: 1.5707963267948966
// expect: 0 3.141592653589793
// expect: NaN
// expect: 0.5235987755982989
// expect: 1.5707963267948966 -1.5707963267948966
// expect: NaN
// expect: 0.7853981633974483
// expect: 0 1.5707963267948966
// expect: math.atan(X)
// expect: -1
// expect: 1
// expect: NaN math.cos(X)
// expect: 1
// expect: 0
// expect: NaN math.sin(X)
// expect: 1
// expect: 0
// expect: NaN math.tan(X)
// expect: 2 -1
// expect: 2 0
// expect: math.ceil(X)
// expect: 1 -2
// expect: 2 0
// expect: math.floor(X)
// expect: 1 2
// expect: 3 -2
// expect: 0 math.round(X)
// expect: 4
// expect: 0 1.4142135623730951
// expect: NaN
// expect: 1
// expect: 0 -Infinity
// expect: NaN
// expect: 2.718281828459045
// expect: 2 3
// expect: not 3
// expect: 3.141592653589793
// expect: 3 4
// expect: not 3
// expect: 2 3
// expect: 4.9E-324 2 1
// expect: math.max(1,X)
// expect: 1 1
// expect: 1.7976931348623157E308 2 1
// expect: math.min(1,X)
// expect: 6.5
// expect: 0 1
// expect: math.sum(a)
// expect: 3
// expect: 4 1
// expect: NaN math.average(a)
// expect: 3
// expect: 4
// expect: math.mean([]) math.mean(a)
// expect: 2
// expect: 4 2.5
// expect: math.median([]) math.median([a])
// expect: 1
// expect: 0 NaN
// expect: math.std_dev(a)
// expect: up to 1
// expect: up to 5
// expect: 0
// expect: math.random(X)
// expect: 2 3
// expect: 0 0
// expect: .length(X) .length(a)
// expect: 2 1
// expect: 0 1
// expect: not 3
// expect: a number
// expect: never back
// expect: since 1970
