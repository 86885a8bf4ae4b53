// Everything here parses.
steps_left(5).

!wlak.

+!walk : at(X, Y) & grdi(Rows, _) & X < Rows <- mvoe(left); !walk(again).
+!walk : stesp_left(0)                       <- .prnit("done"); stay(now).
+!walk                                       <- .random; walk.

!silenced.  // jaywalk: allow unknown-goal
