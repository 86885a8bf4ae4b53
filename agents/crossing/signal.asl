// A traffic signal: green, amber and red for vehicles, in turns.

green(10).  // ticks
amber(2).
red(8).

!run.

+!run : green(G) & amber(A) & red(R)
  <- !hold(green, G);
     !hold(amber, A);
     !hold(red, R);
     !run.

+!hold(Colour, Ticks) : Ticks > 0 <- show(Colour); !hold(Colour, Ticks - 1).
+!hold(_, _).
