// Election by intersect: of the pedestrians whom crossing leads into the precondition zone of the
// AV, the one to get there first is elected; the others walk on.

{ include("shared/voting.asl") }
{ include("shared/prediction.asl") }

bid(Ticks) :- meets_av_in(Ticks).
