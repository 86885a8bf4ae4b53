// .lower_case of strings, and of other terms by their text.
!start.
+!start <- .lower_case("CArtAgO 1", R); .print(R); .lower_case("", E); .length(E, N); .print(N); .lower_case("abc", "abc"); !failure.
+!failure <- .lower_case("ABC", "ABC"); .print("never").
-!failure[error(E)] <- .print(E).
// expect: cartago 1
// expect: 0
// expect: ia_failed
