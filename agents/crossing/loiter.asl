// Loiter: stands with a foot in the AV's lane while a careful driver has all the time to stop, and
// sets out when the AV, which has not stopped, is about to pass.

{ include("shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !get(beside); !put_a_foot_in; !loiter.

+!put_a_foot_in : avoids(0) <- !get(toe).
+!put_a_foot_in             <- !wait; !put_a_foot_in.

+!loiter : gone          <- !get(beside).
+!loiter : in_path       <- !wait; !loiter.
+!loiter : about_to_pass <- !get(middle); !loiter.
+!loiter : stands        <- !get(out).
+!loiter                 <- !wait; !loiter.
