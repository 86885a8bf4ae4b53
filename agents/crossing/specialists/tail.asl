// Tail: walks along the lane beside the AV's path, against the AV, whatever that does, and turns in
// when it is about to pass.

{ include("../shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !come_into_view; !get(beside); !step_into_the_lane; !tail.

+!step_into_the_lane : avoids(0) & not gone <- !get(brim).
+!step_into_the_lane                        <- !wait; !step_into_the_lane.

+!tail : gone          <- !get(beside).
+!tail : in_path       <- !wait; !tail.
+!tail : about_to_pass <- !get(middle); !tail.
+!tail : stands        <- !get(out); !get(beside).
+!tail : near_the_limit <- !along(forward); !tail.
+!tail <- !along(back); !tail.

near_the_limit :- spare(0, M) & M < 1.
