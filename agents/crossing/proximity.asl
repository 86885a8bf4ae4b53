// Proximity: walk along the pavement, and cross the road as soon as the AV is near.

{ include("shared/alone.asl") }
{ include("shared/nearness.asl") }

time_to_cross :- distance_to_av(D) & near(D).
