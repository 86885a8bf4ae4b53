// Sweeps the ground row by row. Carries garbage to r2, and goes on where it found it.

!sweep.

+!sweep : garbage(r1) & pos(r1, X, Y) & pos(r2, X2, Y2)
  <- .print("garbage at ", X, ",", Y);
     !pick_up;
     !walk(X2, Y2);
     drop(garb);
     !walk(X, Y);
     !sweep.
+!sweep <- next(slot); !sweep.

// The arm slips at times: as long as the garbage lies here it has not picked it up.
+!pick_up : garbage(r1) <- pick(garb); !pick_up.
+!pick_up.

+!walk(X, Y) : pos(r1, X, Y).
+!walk(X, Y) <- move_towards(X, Y); !walk(X, Y).
