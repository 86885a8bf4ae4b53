// An election by messages. In every tick until one is elected, each pedestrian tells all others its
// bid, or that it abstains. Messages arrive within the tick, so that each decides when the last bid
// comes in, and all decide on the same bids. The lowest bid wins; of equal bids, the lowest id. The
// including program defines the bids by rules. jaywalk: asks bid/1

{ include("steps.asl") }

!exercise_av.

+!exercise_av <- !set_out; !vote.

+!vote : tick(T) & id(Me) & bid(Number) <- !announce(bid(T, Me, Number)).
+!vote : tick(T) & id(Me)               <- !announce(bid(T, Me, abstains)).

+!announce(Bid) <- .broadcast(tell, Bid); +Bid.

+bid(T, _, _) : pedestrians(N) & .count(bid(T, _, _), N) <- !decide(T).

elected(T, Id) :-
  .findall(b(Number, I), bid(T, I, Number) & Number \== abstains, Bids) & .min(Bids, b(_, Id)).

+!decide(T) : elected(T, Me) & id(Me) <- !cross_road.
+!decide(T) : elected(T, _)           <- !keep_walking.
+!decide(_)                           <- !walk; !vote.

+!keep_walking <- !walk; !keep_walking.
