// Intersect: walk along the pavement, and cross the road as soon as that leads into the AV's
// precondition zone.

{ include("shared/alone.asl") }
{ include("shared/prediction.asl") }

time_to_cross :- meets_av_in(_).
