// .log writes from info on; what is finer is dropped, what is graver goes to the log.
!start.
+!start <- .log(info, "x ", 1, [a]); .log(fine, "dropped"); .log(finest, "dropped"); .log(warning, "grave").
// expect: x 1[a]
// expect log: grave
