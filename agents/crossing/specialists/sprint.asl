// Sprint: steps out at the last moment, but slowly, like a pedestrian that will let the AV pass; runs
// when it is the last moment to get into the AV's path.

{ include("../shared/stepping.asl") }

slow(0.5).  // m/s
fast(3).    // m/s, or as fast as it can

!exercise_av.

+!exercise_av
  <- !set_out_across;
     !come_into_view;
     !get(beside);
     !wait_for_the_brink;
     ?slow(V);
     -+pace(V);
     !dawdle.

+!dawdle : in_path & gap(M) & M < 20 & not stands <- !wait; !dawdle.
+!dawdle : would_come_in_time <- ?fast(V); -+pace(V); !get(middle); !dawdle.
+!dawdle : stands <- -+pace(1.5); !get(out).
+!dawdle <- !to(middle); !dawdle.

would_come_in_time :-
  side(Side) & place(middle, Side, X) & x(M) & fast(V) & walking_speed(W) & cell_length(C) &
  tick_length(L) & S = math.max(0, math.abs(X - M) - 1.75) / math.min(V, W * C / L) & not in_path &
  avoids(0) & comes_by(0, S + 2 * L).
