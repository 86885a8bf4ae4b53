// Brink: waits beside the AV's lane and steps out at the last moment at which a careful and competent
// driver would still avoid it, if the AV meets it unless it brakes.

{ include("shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !get(beside); !wait_for_the_brink; !get(out).
