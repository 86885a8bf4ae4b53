// Directed learner: has the desires that a pedestrian who tests an AV can have, and learns which of
// them to pursue (jaywalk learn). It chooses anew as soon as what it sees of the situation changes.

{ include("shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !go_on.

// What was chosen is pursued as long as nothing changes.
+!go_on : pursuing(Desire, Seen) & observation(desire, Seen) <- !pursue(Desire); !go_on.
+!go_on : observation(desire, Seen)
  <- !choose(Desire);
     -+pursuing(Desire, Seen);
     !pursue(Desire);
     !go_on.

@wait[learned(desire)] +!choose(wait).
@retreat[learned(desire)] +!choose(retreat).
@lure[learned(desire)] +!choose(lure).
@cross[learned(desire)] +!choose(cross).
@draw_on[learned(desire)] +!choose(draw_on) : in_lane.

+!pursue(wait)    <- !wait.
+!pursue(retreat) <- !turn_round; !to(beside).
+!pursue(lure)    <- !to(toe).
+!pursue(cross)   <- !to(middle).
+!pursue(draw_on) <- !along(forward).

// Where it is, what the AV does, in half seconds how soon it comes, and whether a careful driver could
// still just avoid it if it stepped out.
observation(desire, [Where, Drives, Soon, Brink]) :-
  where(Where) & drives_as(Drives) & soon(Soon) & brink(Brink).

where(2) :- in_path.
where(1) :- in_lane & not in_path.
where(0) :- not in_lane.

drives_as(2) :- stands.
drives_as(1) :- slows & not stands.
drives_as(0) :- not slows & not stands.

soon(-1) :- gone.
soon(S)  :- not gone & not stands & comes_in(T) & S = math.floor(math.min(T, 8) * 2).
soon(20) :- not gone & stands & gap(M) & M < 4.
soon(21) :- not gone & stands & gap(M) & M >= 4.

brink(1) :- not in_lane & on_the_brink.
brink(2) :- in_lane & about_to_pass.
brink(0) :- not (not in_lane & on_the_brink) & not (in_lane & about_to_pass).
