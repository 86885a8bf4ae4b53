// How far away the AV is, and whether that is near. jaywalk: asks rows_to/4

radius(15).               // cells within which the AV is near
radius_limit(exclusive).  // is the radius itself near? exclusive, inclusive, inclusive_alone

// City-block distance: cells to the AV, whether it comes or has passed, and rows to its lane.
distance_to_av(D) :-
  at(X, Y) & av(AvY) & av_lane(First, Last) & rows_to(X, First, Last, Rows) &
  D = math.abs(Y - AvY) + Rows.

av_lane(First, Last) :- av_rows(Row, _) & lane(First, Last, _) & First <= Row & Row <= Last.

near(D) :- radius(R) & D < R.
near(R) :- radius(R) & (radius_limit(inclusive) | radius_limit(inclusive_alone) & pedestrians(1)).
