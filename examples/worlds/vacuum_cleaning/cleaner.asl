// Goes round the house and sucks wherever it is dirty.

way_from(1, right).
way_from(2, down).
way_from(4, left).
way_from(3, up).

!patrol.

+!patrol : dirty <- suck; !patrol.
+!patrol : pos(Room) & way_from(Room, Move) <- Move; !patrol.
