// Without any failure plan the intention is lost, alone.
!start. !other.
+!start <- !a; .print("never").
+!a <- .fail.
+!other <- .print("one"); .print("two"); .print("three").
// expect: one
// expect: two
// expect: three
// expect log: no failure event was generated
