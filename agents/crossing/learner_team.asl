// Team learner: as learner, one of several that share one reward (learning.shared). They send no
// messages; each can learn a role of its own by its number.

{ include("shared/steps.asl") }

!roam.

+!roam <- !step; !roam.

@forward[learned(step)] +!step : free(forward)               <- move(forward).
@back[learned(step)] +!step    : free(back)                  <- move(back).
@across[learned(step)] +!step  : way_across(Way) & free(Way) <- move(Way).
@stand[learned(step)] +!step                                 <- stay.

observation(step, [Me, Rows, Y - Front]) :-
  id(Me) & at(X, Y) & av(Front) & zone_rows(First, Last) & rows_to(X, First, Last, Rows).
