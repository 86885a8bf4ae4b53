// Variables within structures get their values back, too.
!start.
+!start <- !fill(pair(A, [B])); .print(A, " ", B).
+!fill(pair(X, [Y])) <- X = left; Y = right.
// expect: left right
