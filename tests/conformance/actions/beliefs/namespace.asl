// .namespace tests a namespace or goes through them all.
n::p(1). default::p(2).
!start.
+!start
  <- .findall(N, .namespace(N) & (N == n | N == default), L); .sort(L, S); .print(S);
     if (.namespace(n)) { .print("n is one") }; if (not .namespace(m)) { .print("m is none") }.
// expect: [default,n]
// expect: n is one
// expect: m is none
