// Learner: in every tick one of a handful of steps, which one is learned (jaywalk learn). All that it
// uses of the road is how many rows away the AV drives, and how far ahead of the AV it is itself.
// Without a policy all possible steps are equally probable.

{ include("shared/steps.asl") }

!roam.

+!roam <- !step; !roam.

@forward[learned(step)] +!step : free(forward)               <- move(forward).
@back[learned(step)] +!step    : free(back)                  <- move(back).
@across[learned(step)] +!step  : way_across(Way) & free(Way) <- move(Way).
@stand[learned(step)] +!step                                 <- stay.

observation(step, [Rows, Y - Front]) :-
  at(X, Y) & av(Front) & zone_rows(First, Last) & rows_to(X, First, Last, Rows).
