// math.round rounds half up, math.floor and math.ceil to whole numbers.
!start.
+!start <- .print(math.round(2.5)); .print(math.round(-2.5)); .print(math.floor(-1.5)); .print(math.ceil(1.2)).
// expect: 3
// expect: -2
// expect: -2
// expect: 2
