// Tail: walks along the lane beside the AV's path, against the AV, and turns in when that is about to
// pass.

{ include("shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !get(beside); !step_into_the_lane; !tail.

+!step_into_the_lane : avoids(0) & not gone <- !get(brim).
+!step_into_the_lane                        <- !wait; !step_into_the_lane.

+!tail : gone          <- !get(beside).
+!tail : in_path       <- !wait; !tail.
+!tail : about_to_pass <- !get(middle); !tail.
+!tail : stands        <- !get(out).
+!tail : slows         <- !wait; !tail.
+!tail                 <- !along(back); !tail.
