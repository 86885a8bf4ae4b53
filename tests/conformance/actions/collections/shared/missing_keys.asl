// A key that is not there has its default or fails.
!start.
+!start <- .map.create(M); .map.get(M, k, V, 5); .print(V); !get(M); !remove(M).
+!get(M) <- .map.get(M, k, _); .print("never").
-!get(_)[error(E)] <- .print(E).
+!remove(M) <- .map.remove(M, k, _); .print("never").
-!remove(_)[error(E)] <- .print(E).
// expect: 5
// expect: ia_failed
// expect: ia_failed
