// Arithmetic in initial beliefs is evaluated when the program is read.
ok(7 div 2).
b([1, f(1 div 0)]).
// expect error 3:1: division by zero in a belief
