// Walks along the pavement, or stands, and crosses the road from a given moment on; on the way it may
// change its mind once. It decides nothing itself: a search sets all its parameters.

{ include("shared/steps.asl") }

cross_at(5).  // tick
ahead(none).  // or, instead of cross_at: seconds in the AV's path before the AV, if that drives on
changes_mind(never).  // or seconds before it would get into that path; negative: after
meanwhile(back).  // back, stand, forward (as the AV drives) or along (towards the AV)
pause(1).  // seconds after which it goes on across
moves(none).  // or, in place of all that, a letter for each tick: forward, back, left, right, stay

!begin.

+!begin : moves(Moves) & not Moves = none & .term2string(Moves, Letters) <- !follow(Letters, 0).
+!begin : not ahead(none) & ahead(S) & ticks_to_path(N) & comes_in(T) & tick_length(L) & tick(Now)
  <- +sets_out(math.round(Now + T - N - S / L));
     !stroll.
+!begin <- !stroll.

+!stroll : time_to_cross   <- !cross_by_script.
+!stroll : first_way(none) <- stay; !stroll.
+!stroll : not way(_)      <- !set_out; !stroll.
+!stroll                   <- !walk; !stroll.

time_to_cross :- ahead(none) & tick(T) & cross_at(Start) & T >= Start.
time_to_cross :- sets_out(Start) & tick(T) & T >= Start.

// Ticks until the AV is level with this pedestrian's cell, and until this pedestrian is in its path.
comes_in(T) :- av(Y) & at(_, Own) & av_speed(V) & V > 0 & T = (Own - Y) / V.
ticks_to_path(N) :-
  at(X, _) & av_rows(First, _) & X < First & walking_speed(V) & N = (First - X - 0.5) / V.
ticks_to_path(N) :-
  at(X, _) & av_rows(_, Last) & X > Last & walking_speed(V) & N = (X - Last - 0.5) / V.

+!cross_by_script
  : changes_mind(S) & not changes_mind(never) & pause(P) & tick_length(L) & ticks_to_path(N) &
    way_across(Way) & meanwhile(What) & turned(What, Way, Other)
  <- !steps(math.round(N - S / L), Way);
     !steps(math.round(P / L), Other);
     !cross(Way).
+!cross_by_script <- !cross_road.

turned(back, left, right).
turned(back, right, left).
turned(stand, _, nowhere).
turned(forward, _, forward).
turned(along, _, back).

+!steps(N, _) : N <= 0.
+!steps(N, Way) : free(Way) <- move(Way); !steps(N - 1, Way).
+!steps(N, Way)             <- stay; !steps(N - 1, Way).

// Moves letter by letter, then stays; waits for an obstacle in the way to leave.
+!follow(Letters, I)
  : .length(Letters, N) & I < N & .substring(Letter, Letters, I, I + 1) & letter(Letter, Way) &
    free(Way)
  <- move(Way);
     !follow(Letters, I + 1).
+!follow(Letters, I) <- stay; !follow(Letters, I + 1).

letter("f", forward).
letter("b", back).
letter("l", left).
letter("r", right).
