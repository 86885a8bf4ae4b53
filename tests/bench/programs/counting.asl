first(0).
last(5).
!start.
+!start : first(X) <- +reached(X); !count.
+!count : reached(X) & last(Y) & X < Y <- Next = X + 1; -+reached(Next); !count.
+!count : reached(X) & last(Y) & X >= Y.
