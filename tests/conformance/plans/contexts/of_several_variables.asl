// Joins go from left to right, and the first that fits everything is taken.
near(ann, 3). near(bob, 1). near(cid, 2).
likes(bob, tea). likes(cid, cake).
!start.
+!start : near(Who, D) & likes(Who, What) & D < 3 <- .print(Who, " ", What).
// expect: bob tea
