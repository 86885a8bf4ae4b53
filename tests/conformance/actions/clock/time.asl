// .time, .date, .nano_time and .version give numbers and a text; a wrong expectation fails.
!start.
+!start
  <- .time(H, M, S); .time(H2, M2, S2, Ms); if (H >= 0 & H < 24 & M < 60 & S < 60 & H2 < 24 & M2 < 60 & S2 < 60 & Ms < 1000) { .print("a time") };
     .date(Y, Mo, D); if (Y > 1969 & Mo >= 1 & Mo <= 12 & D >= 1 & D <= 31) { .print("a date") };
     .nano_time(N1); .nano_time(N2); if (N2 >= N1) { .print("goes on") }; .version(V); if (.string(V)) { .print("a text") };
     T = system.time; if (T > 0) { .print("since 1970") }; !time; !date; !version.
+!time <- .time(25, _, _); .print("never").
-!time[error(E)] <- .print(E).
+!date <- .date(_, 13, _); .print("never").
-!date[error(E)] <- .print(E).
+!version <- .version("none"); .print("never").
-!version[error(E)] <- .print(E).
// expect: a time
// expect: a date
// expect: goes on
// expect: a text
// expect: since 1970
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
