// Brink: waits beside the AV's lane and steps out at the last moment at which a careful and competent
// driver would still avoid it, if the AV meets it unless it brakes; stands in the AV's path until the
// AV has stopped or passed.

{ include("../shared/stepping.asl") }

!exercise_av.

+!exercise_av
  <- !set_out_across;
     !get(beside);
     !wait_for_the_brink;
     !get(middle);
     !stand.

+!stand : not gone & not stands <- !wait; !stand.
+!stand                         <- !get(out).
