// A cyclist (or any other vehicle): goes its way, stops for road users right in front of it and
// before a crosswalk whose signal is not green.

riding(back).  // its way: back, against the AV, or forward
clearance(4).  // cells that it keeps to others ahead

!ride.

ahead(Y, Other, Gap) :- riding(back) & Gap = Y - Other & Gap > 0.
ahead(Y, Other, Gap) :- riding(forward) & Gap = Other - Y & Gap > 0.

in_the_way :-
  at(X, Y) & road_user(_, _, OtherX, OtherY, _, _) & math.abs(X - OtherX) < 1 &
  ahead(Y, OtherY, Gap) & clearance(Least) & Gap < Least.

near_side(First, _, First) :- riding(forward).
near_side(_, Last, Last)   :- riding(back).

must_stop :-
  // Where a road has no signals there is none to stop for. jaywalk: allow absent-percept
  signal(N, Colour) & Colour \== green & crosswalk(N, First, Last, _) &
  near_side(First, Last, Line) & at(_, Y) & ahead(Y, Line, Gap) & clearance(Least) & Gap < Least.

+!ride : in_the_way  <- stay; !ride.
+!ride : must_stop   <- stay; !ride.
+!ride : riding(Way) <- move(Way); !ride.
// At the end of the road the rider has left the world, and its ride ends.
-!ride.
