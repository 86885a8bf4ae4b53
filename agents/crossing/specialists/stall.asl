// Stall: walks out in good time, stops in the AV's path and stands there; when the AV has waited long
// enough, or drives on, it goes on.

{ include("../shared/stepping.asl") }

steps_out(4).    // s before the AV comes
stands_for(20).  // s

!exercise_av.

+!exercise_av
  <- !set_out_across;
     !get(beside);
     ?steps_out(S);
     !wait_for_the_av(S);
     !get(middle);
     ?now(Now);
     +stopped(Now);
     !stall.

+!stall : stopped(Since) & now(S) & stands_for(Most) & S - Since > Most <- !get(out).
+!stall : moves_off & gap(M) & M < 1 <- !get(far); !wait; !stall.
+!stall <- !wait; !stall.
