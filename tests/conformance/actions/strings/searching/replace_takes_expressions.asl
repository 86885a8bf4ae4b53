// .replace replaces all that a regular expression matches; groups can be named in the text.
!start.
+!start
  <- .replace("banana", "a", "o", A); .print(A); .replace("a1b22", "[0-9]+", "#", B); .print(B);
     .replace("ann bob", "([a-z]+) ([a-z]+)", "$2 $1", C); .print(C); .replace("x", "y", "z", D); .print(D).
// expect: bonono
// expect: a#b#
// expect: bob ann
// expect: x
