// Intersect, as the paper's draft words it: cross the road as soon as the AV would not have passed
// when the pedestrian is in front of it, however far away the AV is then. Crosses far too early.

{ include("shared/alone.asl") }
{ include("shared/prediction.asl") }

time_to_cross :- in_zone_rows_in(T) & zone_in(T, From, _) & at(_, Y) & From <= Y.
