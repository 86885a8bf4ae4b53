// What the actions of chance, time and files do ordinarily, at the boundary, and when they fail.
!start.
+!start
  <- for (.member(A, [".random", ".set_random_seed", ".time", ".date", ".nano_time", ".version", ".list_files"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".random") <- .random(X); .random([a, a], Y); if (X >= 0 & X < 1) { .print("from 0 up to 1, ", Y) }.
+!boundary(".random") <- .random([x], X); .findall(Y, .random([y], Y, 2), L); .findall(Z, .random(Z, 3), M); .length(M, N); .print(X, L, N).
+!failure(".random") <- .random([a], b).
+!ordinary(".set_random_seed") <- .set_random_seed(7); .random(X); .set_random_seed(7); .random(Y); if (X == Y) { .print("repeated") }.
+!boundary(".set_random_seed") <- .set_random_seed(0); .random(X); .print(X).
+!failure(".set_random_seed") <- .set_random_seed(a).
+!ordinary(".time") <- .time(H, M, S); if (H >= 0 & H < 24 & M < 60 & S < 60) { .print("a time") }.
+!boundary(".time") <- .time(_, _, _, Ms); if (Ms >= 0 & Ms < 1000) { .print("thousandths") }.
+!failure(".time") <- .time(24, _, _).
+!ordinary(".date") <- .date(Y, M, D); if (Y > 1999 & M >= 1 & M <= 12 & D >= 1 & D <= 31) { .print("a date") }.
+!boundary(".date") <- .date(Y, M, D); .date(Y, M, D); .print("the same").
+!failure(".date") <- .date(_, 0, _).
+!ordinary(".nano_time") <- .nano_time(X); if (.number(X)) { .print("a number") }.
+!boundary(".nano_time") <- .nano_time(X); .nano_time(Y); if (X <= Y) { .print("never back") }.
+!failure(".nano_time") <- .nano_time(a).
+!ordinary(".version") <- .version(V); if (.string(V)) { .print("a text") }.
+!boundary(".version") <- .version(V); .version(V); .print("the same").
+!failure(".version") <- .version(3).
+!ordinary(".list_files") <- .list_files("tests/conformance/actions/clock", ".*time.*", [F]); .substring("time.asl", F); .print("found").
+!boundary(".list_files") <- .list_files("tests/conformance/actions/clock", "none", L); .list_files("tests/conformance/actions/clock", M); .length(M, N); .print(L, N).
+!failure(".list_files") <- .list_files("tests/conformance/actions/clock", []).
// expect: from 0 up to 1, a
// expect: x[y,y]3
// expect: .random wrong_arguments
// expect: repeated
// expect: 0.730967787376657
// expect: .set_random_seed unknown
// expect: a time
// expect: thousandths
// expect: .time ia_failed
// expect: a date
// expect: the same
// expect: .date ia_failed
// expect: a number
// expect: never back
// expect: .nano_time ia_failed
// expect: a text
// expect: the same
// expect: .version ia_failed
// expect: found
// expect: []2
// expect: .list_files ia_failed
