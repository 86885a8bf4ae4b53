// math.sum, average, mean, median, std_dev of lists; what is no number is left out or keeps the term.
!start.
+!start
  <- .print(math.sum([1, 2, 3.5]), " ", math.sum([]), " ", math.sum([1, a])); .print(math.average([1, 2, 6]), " ", math.average([]));
     .print(math.mean([1, 2, 6]), " ", math.mean([5])); .print(math.median([5, 1, 3]), " ", math.median([4, 1, 3, 2]), " ", math.median([7]));
     .print(math.std_dev([2, 4, 4, 4, 5, 5, 7, 9]) > 2.13, " ", math.std_dev([1, 3]) == math.sqrt(2)); .print(math.mean([])); .print(math.median([]));
     .print(math.mean([1, a, 3]), " ", math.std_dev([1, a, 1]), " ", math.std_dev([]), " ", math.median([1, a])).
// expect: 6.5 0 1
// expect: 3 NaN
// expect: 3 5
// expect: 3 2.5 7
// expect: (2.138089935299395 > 2.13) (1.4142135623730951 == 1.4142135623730951)
// expect: math.mean([])
// expect: math.median([])
// expect: 2 0 0 math.median([1,a])
