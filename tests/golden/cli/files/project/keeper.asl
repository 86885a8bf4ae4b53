colour(blue).

!look(3).

+colour(C) <- .print("colour ", C).
+!look(N) <- ?colour(C); .print("look ", N, " ", C).
