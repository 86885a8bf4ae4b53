// What is given beside the variable is passed over: the set or map is empty.
!go.
+!go <- .set.create(S,[1]); .print(S); .set.add(S,0); .print(S); .map.create(M,[1]); .print(M).
// expect: {}
// expect: {0}
// expect: {}
