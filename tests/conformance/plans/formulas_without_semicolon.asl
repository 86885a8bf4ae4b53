// As in older Jasons a formula may follow without a semicolon, if it looks like one: in the next line
// and indented, or where no clause can begin.
!start.
+!start
  <- ?c(X)
     .print(X)
     Y = X + 1;
     +d(Y)
     -+e(Y)
     ++f(Y)
     if (d(Z)) { .print(Z) }
     .concat(a, b, T)print(T);
     .print(never).
-!start[error(E)]
  <- .print(E)
     ?e(X)
     !last(X).
+!last(X) <-
.print(last)
for (.member(Y, [X, 3])) {
.print(Y)
.print(Y + 1)
}
.print(end).
c(1).
// expect: 1
// expect: 2
// expect: action_failed
// expect: last
// expect: 2
// expect: 3
// expect: 3
// expect: 4
// expect: end
