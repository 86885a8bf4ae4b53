// Election: of the pedestrians near the AV the nearest one is elected to cross the road; the others
// walk on.

{ include("shared/voting.asl") }
{ include("shared/nearness.asl") }

bid(D) :- distance_to_av(D) & near(D).
