// Repeat: crosses in good time, turns round at once and crosses a second time, on the brink; and so on.

{ include("shared/stepping.asl") }

steps_out(3.2).  // s before the AV comes, the first time

!exercise_av.

+!exercise_av
  <- !set_out_across;
     !get(beside);
     ?steps_out(S);
     !wait_for_the_av(S);
     !get(out);
     !cross_again.

+!cross_again : gone.
+!cross_again : on_the_brink <- !turn_round; !get(out); !cross_again.
+!cross_again <- !wait; !cross_again.
