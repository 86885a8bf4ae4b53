// A cyclist (or any other vehicle): goes its way and stops for whoever is right in front of it.

riding(back).  // its way: back, against the AV, or forward
clearance(4).  // cells that it keeps to others ahead

!ride.

ahead(Y, Other, Gap) :- riding(back) & Gap = Y - Other & Gap > 0.
ahead(Y, Other, Gap) :- riding(forward) & Gap = Other - Y & Gap > 0.

in_the_way :-
  at(X, Y) & road_user(_, _, OtherX, OtherY, _, _) & math.abs(X - OtherX) < 1 &
  ahead(Y, OtherY, Gap) & clearance(Least) & Gap < Least.

+!ride : in_the_way  <- stay; !ride.
+!ride : riding(Way) <- move(Way); !ride.
// Where the road ends, its ride does.
-!ride.
