// Directed learner: has the desires that a pedestrian who tests an AV can have, and learns which of
// them to pursue (jaywalk learn). It chooses anew as soon as what it sees of the situation changes.

{ include("shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !go_on.

// Pursues the chosen desire as long as what it sees does not change.
+!go_on : pursuing(Desire, Seen) & observation(desire, Seen) <- !pursue(Desire); !note; !go_on.
+!go_on : observation(desire, Seen)
  <- !choose(Desire);
     -+pursuing(Desire, Seen);
     !pursue(Desire);
     !note;
     !go_on.

// A foot in its lane, one place or another in its path, or on in its lane so that it moves off.
@wait[learned(desire)] +!choose(wait).
@retreat[learned(desire)] +!choose(retreat).
@lure[learned(desire)] +!choose(toe)         : not gone.
@step_out[learned(desire)] +!choose(near)    : not gone.
@meet[learned(desire)] +!choose(middle)      : not gone.
@go_over[learned(desire)] +!choose(far)      : in_lane & not gone.
@go_beyond[learned(desire)] +!choose(beyond) : in_lane & not gone.
@draw_on[learned(desire)] +!choose(draw_on)  : in_lane & not gone.

+!pursue(wait) <- !wait.
+!pursue(retreat) : side(Side) & place(beside, Side, X) & there(X)
  <- !turn_round;
     !rest;
     !come_to_the_brink.
+!pursue(retreat) <- !turn_round; !rest; !to(beside).
+!pursue(draw_on) : not drawing <- +drawing; !wait.
+!pursue(draw_on) : in_path     <- !leave_path.
+!pursue(draw_on)
  : leads(M) & M < 1 & driver(F, _, _) & near(N) & N - F < 4.5 & not at_a_car & free(forward)
  <- !along(forward).
+!pursue(draw_on) : side(Side) & place(beside, Side, X) <- !step_to(X).
+!pursue(Place) <- !to(Place).
+!leave_path : side(Side) & place(brim, Side, X) <- !step_to(X).

// Metres that the AV is ahead of where a careful driver would be by now.
leads(M) :- av_seen(F, _, _) & driver(D, _, _) & M = F - D.
at_a_car :- side(Side) & parked(Side, From, To) & far(Y) & Y > From - 0.3 & Y < To.

// How often it has drawn the AV on; how that first reacted, as the driver would or otherwise; since
// when it stands.
+!rest : drawing & draws(N) <- -drawing; -+draws(N + 1).
+!rest : drawing <- -drawing; +draws(1).
+!rest.
+!note : not reacted(_) & reacts(How) <- +reacted(How); !note_stand.
+!note <- !note_stand.
+!note_stand : stands & not stood_since(_) & now(S) <- +stood_since(S).
+!note_stand : not stands & stood_since(_) <- -stood_since(_).
+!note_stand.

reacts(1) :-
  slows & driver(_, V, _) & cruise(Most) & V < Most - 0.8 & leads(M) & math.abs(M) < 0.2 &
  av_seen(_, Av, _) & Av - V < 0.3.
reacts(2) :- leads(M) & M > 2.5 & (slows | stands).

// Where it is, what the AV does, how soon that comes or how long it has stood how near, whether this
// is the moment to step out or to be met, and what it remembers.
observation(desire, [Where, Drives, Soon, Moment, How, Draws]) :-
  where(Where) & drives_as(Drives) & soon(Soon) & moment(Moment) & how(How) & times(Draws).

where(2) :- in_path.
where(1) :- in_lane & not in_path.
where(0) :- not in_lane.

drives_as(2) :- stands.
drives_as(1) :- slows & not stands.
drives_as(0) :- not slows & not stands.

soon(-1) :- gone.
soon(S)  :- not gone & not stands & comes_in(T) & band(T, S).
soon(10) :- not gone & stands & gap(M) & M < -0.1.
soon(S)  :- not gone & stands & gap(M) & M >= -0.1 & M < 4 & stood(N) & S = 11 + N.
soon(16) :- not gone & stands & gap(M) & M >= 4.

band(T, 0) :- T < 0.5.
band(T, 1) :- T >= 0.5 & T < 1.5.
band(T, 2) :- T >= 1.5 & T < 3.
band(T, 3) :- T >= 3 & T < 4.4.
band(T, 4) :- T >= 4.4.
stood(N) :- stood_since(S) & now(Now) & N = math.floor(math.min((Now - S) / 2.6, 3)).
stood(0) :- not stood_since(_).

moment(1) :- not in_lane & on_the_brink.
moment(2) :- in_lane & about_to_pass.
moment(0) :- not (not in_lane & on_the_brink) & not (in_lane & about_to_pass).

how(H) :- reacted(H).
how(0) :- not reacted(_).
times(N) :- draws(M) & N = math.min(M, 2).
times(0) :- not draws(_).
