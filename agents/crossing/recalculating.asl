// Recalculating: as intersect, but it decides anew in every tick. Where the AV slows, so that the
// way across no longer leads into its precondition zone, it goes back to the roadside that it came
// from, lets the AV come on, and tries again; once the AV has passed, or after some time of this, it
// crosses.

{ include("shared/steps.asl") }
{ include("shared/prediction.asl") }

patience(20).  // s from when the AV first slows

!exercise_av.

+!exercise_av <- ?way_across(Way); +across(Way); ?av_speed(V); +cruise(V); !set_out; !seek_av.

av_has_passed :- at(_, Y) & av(AvY) & AvY >= Y.
av_slows      :- not slowed_in(_) & cruise(Fast) & av_speed(V) & V < Fast.
out_of_patience :-
  slowed_in(Then) & tick(Now) & tick_length(L) & patience(S) & (Now - Then) * L > S.

on_pavement :- at(X, _) & pavement(First, Last) & First <= X & X <= Last.
opposite(left, right).
opposite(right, left).

+!seek_av : (av_has_passed | out_of_patience) & across(Way) <- !cross(Way).
+!seek_av : av_slows & tick(T) <- +slowed_in(T); !seek_av.
+!seek_av : meets_av_in(_) & across(Way) & free(Way) <- move(Way); !seek_av.
+!seek_av : on_pavement <- !walk; !seek_av.
+!seek_av : across(Way) & opposite(Way, Back) <- move(Back); !seek_av.
