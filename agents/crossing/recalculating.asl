// Recalculating: as intersect, but it decides anew in every tick. Where the AV slows, it waits on the
// road until its way leads into the precondition zone again; once the AV has passed, it clears the
// road.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }

!exercise_av.

+!exercise_av <- !set_out; !seek_av.

on_pavement :- at(X, _) & pavement(First, Last) & First <= X & X <= Last.
av_has_passed :- at(_, Y) & av(AvY) & AvY >= Y.

+!seek_av : av_has_passed                    <- !cross_road.
+!seek_av : meets_av_in(_) & way_across(Way) <- move(Way); !seek_av.
+!seek_av : meets_av_in(_)                   <- stay; !seek_av.
+!seek_av : on_pavement                      <- !walk; !seek_av.
+!seek_av                                    <- stay; !seek_av.
