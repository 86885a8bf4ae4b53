// A traffic signal: green, amber and red for vehicles, in turns.

green(10).  // seconds
amber(2).
red(8).

!run.

+!run : green(G) & amber(A) & red(R)
  <- !hold(green, G);
     !hold(amber, A);
     !hold(red, R);
     !run.

+!hold(Colour, Seconds) : tick_length(S) <- !show_for(Colour, math.round(Seconds / S)).

+!show_for(Colour, Ticks) : Ticks > 0 <- show(Colour); !show_for(Colour, Ticks - 1).
+!show_for(_, _).
