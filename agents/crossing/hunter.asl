// Hunter: looks for what the AV does wrong. In every tick it pursues what is worth most as the AV
// now drives: to be hit where it drives on though a pedestrian is in its lane; to try its patience
// where it stands; to make it move off; to step out at the last moment; to lure it; and where it stops
// short of where a careful driver would, to wait until that driver is gone and walk into its path. It
// remembers how the AV reacted. Of several hunters the first in the AV's way lures it. After two
// tries a hunter lets the AV go, unless the careful driver would have gone.

{ include("shared/stepping.asl") }
{ include("shared/company.asl") }

patience(2.6).    // s, how long to try the AV in one place
lures(14).        // m that a lured driver must have left when it stands
lures_from(4.4).  // s before the AV comes
falls_back(2.5).  // m ahead of the driver from which an AV counts as reacting otherwise
stays_back(0.3).  // m short of the driver from which a standing AV counts as standing back

!exercise_av.

+!exercise_av <- +trials([far, near, beyond]); !tell_where_i_stand; !set_out_across; !hunt.

unseen :- driver(F, _, _) & x(X) & near(Y) & hidden(F, X, Y).

somebody_hides_here :-
  id(Me) & stood(Me, Side, _) & stood(Other, Side, _) & Other > Me & in_sight(Other, _, Near) &
  near(Mine) & math.abs(Near - Mine) < 1.5.

// The AV has slowed as the careful driver has, or is by now far ahead of that driver.
reacts(as_a_driver) :-
  slows & driver(_, V, _) & cruise(Most) & V < Most - 0.8 & leads(M) & math.abs(M) < 0.2 &
  av_seen(_, Av, _) & Av - V < 0.3.
reacts(otherwise) :- leads(M) & falls_back(Least) & M > Least & (slows | stands).
leads(M) :- av_seen(F, _, _) & driver(D, _, _) & M = F - D.

can_lure :-
  comes_in(S) & lures_from(Most) & S < Most & not stands & spare(0, M) & lures(Least) & M > Least.

// The driver stands before this pedestrian and waits as long as it is in the lane; or the driver
// passes, since it could not stop any more or its front is already beyond the pedestrian.
driver_waits  :- driver(F, V, _) & V < 0.01 & near(N) & N > F - 0.01.
driver_passes :- not avoids(0) & not driver_waits & not gone.

passes      :- comes_past & gap(M) & M < 0.
stands_back :- stands & leads(M) & stays_back(Least) & M < -Least.

// On a zebra the AV would wait before it; close to the road's end the AV leaves before it has passed.
no_place_to_stand :- on_the_zebra(_).
no_place_to_stand :- road_end(End) & cell_length(C) & av_metres(L) & y(Y) & Y > End * C - L.

// A parked car blocks the other side of the lane, or the way along it.
car_across :-
  home(Side) & parked(Other, From, To) & Other \== Side & far(Y) & Y > From - 5 & near(N) & N < To.
at_a_car :- side(Side) & parked(Side, From, To) & far(Y) & Y > From - 0.3 & Y < To.

// The AV comes to another pedestrian first.
first_to_others :-
  driver(F, _, _) & near(Mine) & in_sight(Id, _, Y) & Id \== me & Y > F + 12 & Y < Mine - 1.

// Let the AV go. A foot in the lane as it passes holds no driver up, but may stop an AV that believes
// pedestrians to be further ahead than they are: it then stands where one can walk into it.
takes_leave    :- draws(N) & N > 1.
about_to_leave :- not stands & not gone & not avoids(0).
stands_beside  :- stands & gap(M) & M < -0.1 & not gone.

+!hunt : desire(Desire) <- !Desire; !hunt.

desire(let_go) :- gone.
desire(step_out) :- takes_leave & driver_gone & not in_lane & on_the_brink.
desire(meet) :- takes_leave & stands_beside & driver_gone.
desire(graze) :- takes_leave & not in_path & (about_to_leave | stands_beside).
desire(let_go) :- takes_leave & not in_lane.
desire(be_ready) :- takes_leave & stands.
desire(be_ready) :- in_lane & stands & driver_gone.
desire(outlast) :- in_lane & not in_path & driver_passes.
desire(outlast) :- in_lane & stands_back & trials([]).
desire(try(Place)) :-
  in_lane & stands & gap(M) & M < 4 & trials([Place|_]) & not (Place == beyond & car_across).
desire(meet) :- in_lane & drives & drawing & about_to_pass.
desire(draw_on) :- in_lane & (stands | drawing).
desire(meet) :- in_lane & not in_path & (about_to_pass | passes & driver_waits).
desire(hold) :- in_lane & aim(_).
desire(be_ready) :- in_lane & unseen & not in_path.
desire(meet) :- in_lane & about_to_pass.
desire(remember(How)) :- in_lane & not reacted(_) & reacts(How).
desire(be_ready) :- in_lane & reacted(_).
desire(come_on) :- in_lane.
desire(stay_by) :- somebody_hides_here & not stands.
desire(step_out) :- on_the_brink.
desire(come_on) :-
  not reacted(_) & can_lure & not first_to_others & side(Side) & not emerges_from(Side).
desire(graze) :- pedestrians(1) & not in_lane & driver_passes & not stands.
desire(be_ready).

+!let_go        <- !wait.
+!hold : aim(X) <- !step_to(X).
+!stay_by       <- !to(beside).
+!be_ready : side(Side) & place(beside, Side, X) & there(X) & no_place_to_stand & free(back)
  <- -aim(_);
     !rest;
     !turn_round;
     !along(back).
+!be_ready : side(Side) & place(beside, Side, X) & there(X)
  <- -aim(_);
     !rest;
     !turn_round;
     !come_to_the_brink.
+!be_ready <- -aim(_); !rest; !turn_round; !to(beside).

// Counts how often it has made the AV move off.
+!rest : drawing & draws(N) <- -drawing; -+draws(N + 1).
+!rest : drawing <- -drawing; +draws(1).
+!rest.

+!graze <- -aim(_); !to(toe).
+!step_out <- !aim_at(near).
+!meet <- !aim_at(middle).

+!aim_at(Place) : home(Side) & place(Place, Side, X) <- -+aim(X); !step_to(X).

+!remember(How) <- +reacted(How); !be_ready.

// Keep a foot in the lane until the AV reacts.
+!come_on : slows <- !wait.
+!come_on <- !to(toe).

// Stand at another place in the AV's lane, for as long as the patience lasts.
+!try(Place) : trying(Place, Since) & now(S) & patience(P) & S - Since > P & trials([_|Rest])
  <- -+trials(Rest);
     !wait.
+!try(Place) : trying(Place, _) <- !aim_at(Place).
+!try(Place) : now(S)           <- -+trying(Place, S); !aim_at(Place).

// Stand beside the AV's path, so far back that the lane is free ahead of the driver, but not of the AV.
+!outlast : in_path      <- !leave_path.
+!outlast : driver_waits <- !along(back).
+!outlast                <- !wait.

// Walk ahead in the AV's lane until a stopped driver would have room to pick up speed, then leave it.
+!draw_on : not drawing <- +drawing; !wait.
+!draw_on : in_path     <- !leave_path.
+!draw_on : on_the_zebra(_) & not at_a_car & free(forward) <- !along(forward).
+!draw_on
  : leads(M) & M < 1 & driver(F, _, _) & near(N) & N - F < 4.5 & not at_a_car & free(forward)
  <- !along(forward).
+!draw_on : side(Side) & place(beside, Side, X) <- !step_to(X).
+!leave_path : side(Side) & place(brim, Side, X) <- !step_to(X).
