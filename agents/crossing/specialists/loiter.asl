// Loiter: stands with a foot in the AV's lane while a careful driver has all the time to stop, and
// sets out when the AV, which has not stopped, is about to pass. When it stops it does the same on
// the other side of the lane.

{ include("../shared/stepping.asl") }

patience(3).  // s, how long to stand at the other side

!exercise_av.

+!exercise_av <- !set_out_across; !come_into_view; !get(beside); !put_a_foot_in; !loiter.

+!put_a_foot_in : avoids(0) <- !get(toe).
+!put_a_foot_in             <- !wait; !put_a_foot_in.

+!loiter : gone                      <- !get(beside).
+!loiter : in_path                   <- !wait; !loiter.
+!loiter : about_to_pass             <- !get(middle); !loiter.
+!loiter : stands & not came_over(_) <- !get(tip); ?now(S); +came_over(S); !loiter.
+!loiter : stands & came_over(Since) & now(S) & patience(P) & S - Since > P <- !get(out).
+!loiter <- !wait; !loiter.
