// 10. Learning: plans labelled `learned(step)` are options; which of them is best is learned.
//
//   jaywalk learn examples/10_learning.yaml --policy learned.json

{ include("$jaywalk/crossing/shared/steps.asl") }

!roam.
+!roam <- !step; !roam.

@forward[learned(step)] +!step : free(forward)               <- move(forward).
@back[learned(step)] +!step    : free(back)                  <- move(back).
@across[learned(step)] +!step  : way_across(Way) & free(Way) <- move(Way).
@stand[learned(step)] +!step                                 <- stay.

// What it chooses by: how many rows away the AV drives, and how far ahead of the AV it is.
observation(step, [Rows, Y - Front]) :-
  at(X, Y) & av(Front) & zone_rows(First, Last) & rows_to(X, First, Last, Rows).
