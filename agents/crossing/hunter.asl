// Hunter: looks for what the AV does wrong. In every tick it pursues what is worth most as the AV now
// drives: to be met by it where it drives on though somebody is in its lane; to try its patience where
// it stands; to draw it on; to step out on the brink; to provoke it from afar. It remembers what the
// AV reacted to, and with others it hides beside one of them.

{ include("shared/stepping.asl") }
{ include("shared/company.asl") }

patience(2.6).  // s, how long to try the AV in one place
provokes(30).   // m beyond the driver's way to stop from where on the AV is provoked

!exercise_av.

+!exercise_av <- +trials([far, near, beyond]); !tell_where_i_stand; !set_out_across; !begin.

+!begin : id(Me) & joins(Me) & post(Post) & stood(Post, _, Y) & in_time(Y)
  <- +reacts_to(nothing_yet);
     !join;
     !hunt.
+!begin <- !hunt.

unseen :- driver(F, _, _) & x(X) & near(Y) & hidden(F, X, Y).

somebody_hides_here :-
  id(Me) & stood(Me, Side, _) & stood(Other, Side, _) & Other > Me & in_sight(Other, _, Near) &
  near(Mine) & math.abs(Near - Mine) < 1.5.

+!hunt : desire(Desire) <- !Desire; !hunt.

desire(let_go) :- gone.
desire(try(Place)) :- in_lane & stands & gap(M) & M < 4 & trials([Place|_]).
desire(meet) :- in_lane & drives & drawing & about_to_pass.
desire(draw_on) :- in_lane & (stands | drawing).
desire(hold) :- in_lane & aim(_).
desire(be_ready) :- in_lane & unseen & not in_path.
desire(meet) :- in_lane & about_to_pass.
desire(come_on) :- in_lane.
desire(stay_by) :- somebody_hides_here & not stands.
desire(step_out) :- on_the_brink.
desire(provoke) :-
  not reacts_to(_) & gap(M) & provokes(Least) & way_to_stop(0, W) & M > W + Least & side(Side) &
  not emerges_from(Side).
desire(be_ready).

+!let_go        <- !wait.
+!hold : aim(X) <- !step_to(X).
+!stay_by       <- !to(beside).
+!be_ready : side(Side) & place(beside, Side, X) & there(X)
  <- -aim(_);
     -drawing;
     !turn_round;
     !come_to_the_brink.
+!be_ready <- -aim(_); -drawing; !turn_round; !to(beside).
+!step_out <- !aim_at(near).
+!meet <- !aim_at(middle).

+!aim_at(Place) : home(Side) & place(Place, Side, X) <- -+aim(X); !step_to(X).

+!provoke : home(Side) & place(beside, Side, Edge) & there(Edge)
  <- +reacts_to(nothing_yet);
     !come_on.
+!provoke <- !be_ready.

// Along the AV's path, against it, until it reacts.
+!come_on : slows <- -+reacts_to(walking); !wait.
+!come_on : home(Side) & place(brim, Side, X) & there(X) <- !along(back).
+!come_on <- !to(brim).

// Somewhere else in its lane, for as long as the patience lasts.
+!try(Place) : trying(Place, Since) & now(S) & patience(P) & S - Since > P & trials([_|Rest])
  <- -+trials(Rest);
     !wait.
+!try(Place) : trying(Place, _) <- !aim_at(Place).
+!try(Place) : now(S)           <- -+trying(Place, S); !aim_at(Place).

// Ahead in its lane until a driver who had stopped would have the way to pick up speed, then out.
+!draw_on : not drawing <- +drawing; !wait.
+!draw_on : in_path     <- !leave_path.
+!draw_on : driver(F, _, _) & near(N) & N - F < 4.5 <- !along(forward).
+!draw_on : side(Side) & place(beside, Side, X) <- !step_to(X).
+!leave_path : side(Side) & place(brim, Side, X) <- !step_to(X).
