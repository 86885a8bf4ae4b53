// Shadow: goes to the far end of a parked car, where the AV cannot see it, and comes out when a careful
// driver who sees it then could just stop. Where the time is short it walks in the lane, so that the
// AV waits. Where nothing hides it, it acts as brink does.

{ include("../shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !hide; !wait_for_the_brink; !get(middle); !stand.

+!hide : hideout(X, Y) & in_time(Y) <- !along_to(Y); !reach(X).
+!hide : hideout(X, Y) <- !get(beside); !wait_for_the_av(5); !get(toe); !along_to(Y); !reach(X).
+!hide <- !get(beside).

+!stand : not gone <- !wait; !stand.
+!stand.

// Behind the car, beside the AV's path.
hideout(X, Y) :-
  side(Side) & parked(Side, _, To) & body(B) & Y = To + B & place(brim, Side, X) & y(M) &
  Y - M < 25 & M - Y < 15.
