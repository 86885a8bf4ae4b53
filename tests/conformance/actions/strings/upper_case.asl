// .upper_case of strings.
!start.
+!start <- .upper_case("CArtAgO 1", R); .print(R); .upper_case("", E); .length(E, N); .print(N); .upper_case("ABC", "ABC"); !failure.
+!failure <- .upper_case("abc", "abc"); .print("never").
-!failure[error(E)] <- .print(E).
// expect: CARTAGO 1
// expect: 0
// expect: ia_failed
