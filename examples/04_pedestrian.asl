// 4. A pedestrian: it walks beside the road until the automated vehicle (AV) is near, then crosses.
//
//   jaywalk run scenarios/paper.yaml --behaviour examples/04_pedestrian.asl --agents 3 --watch

// What the world shows becomes beliefs: at(Row, Cell) is where the pedestrian stands, av(Cell)
// where the front of the AV is. `jaywalk list environments` names the others, and the actions.
near(Cells) :- at(_, Mine) & av(Front) & Mine > Front & Mine < Front + Cells.

// A file that comes with Jaywalk: free(Way) holds if there is room for a step, !cross_road crosses.
{ include("$jaywalk/crossing/shared/steps.asl") }

!stroll.

+!stroll : near(12)      <- !cross_road.
+!stroll : free(forward) <- move(forward); !stroll.  // an action: takes a tick
+!stroll                 <- stay; !stroll.
