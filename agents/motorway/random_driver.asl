// Random driver: whatever a driver can do, by chance.

+tick(_) : .random(R) <- !drive(R).

+!drive(R) : R < 0.2 <- accelerate(2).
+!drive(R) : R < 0.4 <- brake(2).
+!drive(R) : R < 0.45 <- change_lane(left).
+!drive(R) : R < 0.5 <- change_lane(right).
+!drive(_) <- keep.
-!drive(_) <- true.
