// Recalculating: as intersect, but it decides anew in every tick. Where the AV slows, so that the
// way across no longer leads into its precondition zone, it goes back to the roadside that it came
// from, lets the AV come on, and tries again; once the AV has passed, it crosses.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }

!exercise_av.

+!exercise_av <- ?way_across(Way); +across(Way); !set_out; !seek_av.

av_has_passed :- at(_, Y) & av(AvY) & AvY >= Y.

on_pavement :- at(X, _) & pavement(First, Last) & First <= X & X <= Last.
opposite(left, right).
opposite(right, left).

+!seek_av : av_has_passed                <- !cross_road.
+!seek_av : meets_av_in(_) & across(Way) <- move(Way); !seek_av.
+!seek_av : on_pavement                  <- !walk; !seek_av.
+!seek_av : across(Way) & opposite(Way, Back) <- move(Back); !seek_av.
