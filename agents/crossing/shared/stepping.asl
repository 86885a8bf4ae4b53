// Steps across the road to places in metres, with an eye on the AV; and when to step out.

{ include("driver.asl") }
{ include("ways.asl") }

step(M) :-
  pace(V) & tick_length(L) & walking_speed(W) & cell_length(C) & M = math.min(V * L, W * C).

// Ticks until the pedestrian's middle has come to X, or beyond it.
ticks_to(X, N)   :- x(M) & step(D) & N = math.ceil(math.abs(X - M) / D - 0.000001).
ticks_past(X, N) :- x(M) & step(D) & N = math.floor(math.abs(X - M) / D + 0.000001) + 1.

there(X) :- x(M) & math.abs(X - M) < 0.001.

+!step_to(X) : there(X) <- stay; !watch.
+!step_to(X) : x(M) & step(D) & cell_length(C) & X > M
  <- move(right, math.min(D, X - M) / C);
     !watch.
+!step_to(X) : x(M) & step(D) & cell_length(C) <- move(left, math.min(D, M - X) / C); !watch.
-!step_to(_) <- !watch.  // something stands there

+!reach(X) : there(X).
+!reach(X) <- !step_to(X); !reach(X).

// Steps to a place by its name, seen from the side that the pedestrian came from. It leaves a zebra
// first, since the AV would wait before that anyway.
+!set_out_across <- !watch; !turn_round; !step_aside.
+!step_aside : (y(M) & in_the_way(M, Y)) | off_the_zebra(Y) <- !along_to(Y).
+!step_aside.
+!turn_round : side(Side) <- -+home(Side).
+!to(Name) : home(Side) & place(Name, Side, X)  <- !step_to(X).
+!get(Name) : home(Side) & place(Name, Side, X) <- !reach(X).
+!wait <- stay; !watch.

// Along the road: forward is away from the AV, back towards it.
+!along(Way) : free(Way) & step(D) & cell_length(C) <- move(Way, D / C); !watch.
+!along(_) <- stay; !watch.
-!along(_) <- !watch.

+!along_to(Y) : y(M) & math.abs(Y - M) < 0.001.
+!along_to(Y) : y(M) & Y > M + 0.001 & free(forward) <- !along(forward, Y - M); !along_to(Y).
+!along_to(Y) : y(M) & Y < M - 0.001 & free(back)    <- !along(back, M - Y); !along_to(Y).
+!along_to(_).
-!along(_, _) <- !watch.
+!along(Way, M) : step(D) & cell_length(C) <- move(Way, math.min(D, M) / C); !watch.

// A parked car is between the AV's path and the pedestrian when its middle is at M; behind the car, at
// the second argument, it can pass.
in_the_way(M, To + B) :-
  side(Side) & parked(Side, From, To) & body(B) & M > From - B / 2 & M < To + B / 2.

// A place just beyond the zebra that the pedestrian is on, if there is time to walk there.
off_the_zebra(To + B) :- on_the_zebra(To) & body(B) & time_to_walk(beside, To + B).
on_the_zebra(To) :-
  crosswalk(_, First, Last, zebra) & in_metres(First, Last, From, To) &  // jaywalk: allow absent-percept
  y(Y) & Y >= From & Y <= To.

// Leave the shadow of a parked car, to the other side of the lane or further along, if there is time.
+!come_into_view : in_the_shadow(_) & y(Y) & time_to_walk(out, Y) <- !get(out); !turn_round.
+!come_into_view : in_the_shadow(To) & time_to_walk(beside, To + 14) <- !along_to(To + 14).
+!come_into_view.
in_the_shadow(To) :- side(Side) & parked(Side, From, To) & y(Y) & Y > From & Y - To < 22.

// The pedestrian can reach the place across the road, To m along it, before a driver would have to brake.
time_to_walk(Place, To) :-
  side(Side) & place(Place, Side, X) & x(M) & y(Y) & pace(V) & av_seen(_, Av, _) & comes_in(S) &
  (math.abs(X - M) + math.abs(To - Y)) / V + 2 < S + (To - Y) / Av.

// The pedestrian can walk along to Y and be ready before the AV comes.
in_time(Y) :-
  y(M) & pace(V) & av_seen(F, Av, _) & Av > 0 & math.abs(Y - M) / V + 4 < (Y - F) / Av.

gap(M) :- av_seen(F, _, _) & near(N) & M = N - F.
gone   :- av_seen(F, _, _) & av_metres(Length) & far(Y) & F - Length > Y.
drives :- not stands & not slows.
comes_in(S) :- gap(M) & av_seen(_, V, _) & V > 0.01 & S = M / V.
over_lane_for(S) :- risks(Risks) & .member(risk(me, Since), Risks) & now(Now) & S = Now - Since.

// The AV arrives when the pedestrian gets into its path, unless it brakes, as the driver could.
about_to_pass :- comes_past & avoids(0).
comes_past :-
  side(Side) & enters_path(Side, S) & tick_length(L) & not gone & comes_by(0, S + 2 * L).

// If the pedestrian steps out: seconds until it is over the lane and in sight of the driver, until it
// is over the AV's path, and until it is out of that path again.
enters_lane(Side, S) :-
  place(beside, Side, X) & emerges(Side, Y) & further(Side, X, Y, Z) & past(Side, Z, N) &
  tick_length(L) & S = (N - 1) * L.
past(left, X, N)  :- x(M) & X >= M - 0.000001 & ticks_past(X, N).
past(left, X, 1)  :- x(M) & X < M - 0.000001.
past(right, X, N) :- x(M) & X <= M + 0.000001 & ticks_past(X, N).
past(right, X, 1) :- x(M) & X > M + 0.000001.
further(left, X, Y, Z)  :- Z = math.max(X, Y).
further(right, X, Y, Z) :- Z = math.min(X, Y).
enters_path(left, S) :-
  path(From, _) & body(B) & ticks_past(From - B / 2, N) & tick_length(L) & S = N * L.
enters_path(right, S) :-
  path(_, To) & body(B) & ticks_past(To + B / 2, N) & tick_length(L) & S = N * L.
leaves_path(left, S) :-
  path(_, To) & body(B) & ticks_to(To + B / 2, N) & tick_length(L) & S = (N - 1) * L.
leaves_path(right, S) :-
  path(From, _) & body(B) & ticks_to(From - B / 2, N) & tick_length(L) & S = (N - 1) * L.

// Wait beside the lane for the last moment to step out, or for the first moment to be seen.
+!wait_for_the_brink : on_the_brink.
+!wait_for_the_brink <- !come_to_the_brink; !wait_for_the_brink.

// A small step towards the AV makes the last moment to step out coincide with the beginning of a tick.
+!come_to_the_brink : slack(M) & M > 0.02 & free(back) & y(Y) & not in_the_way(Y - M, _)
  <- !along(back, M).
+!come_to_the_brink <- !wait.
slack(M) :-
  driver(F, V, _) & cruise(Most) & V > Most - 0.01 & side(Side) & enters_lane(Side, In) &
  way_to_stop(In, Way) & margin(Least) & near(N) & tick_length(L) & Left = N - F - Way - Least &
  Left > V * L & M = Left - V * L * math.floor(Left / (V * L)).
+!wait_for_the_av(Seconds) : comes_in(S) & S <= Seconds & avoids(0).
+!wait_for_the_av(Seconds) <- !wait; !wait_for_the_av(Seconds).

// A pedestrian that steps out in S seconds is hit if the AV does not brake, and a driver could avoid it.
can_be_avoided_in(S) :-
  side(Side) & enters_path(Side, From) & leaves_path(Side, To) & comes_by(S + From, S + To) &
  enters_lane(Side, In) & avoids(S + In).

// The last tick in which the driver could still avoid a pedestrian that steps out.
on_the_brink :- can_be_avoided_in(0) & tick_length(L) & not can_be_avoided_in(L).
