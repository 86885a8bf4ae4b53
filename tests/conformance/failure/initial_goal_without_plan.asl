// The failure plan is for goals without an intention, too.
!g.
-!g[error(E)] <- .print(E).
// expect: no_relevant
