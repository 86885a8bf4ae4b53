// Walks along the pavement, or stands, and crosses the road from a given moment on; on the way it may
// change its mind once. A pedestrian without a will of its own, for whom a search decides.

{ include("shared/steps.asl") }

cross_at(5).  // tick
ahead(none).  // or, in its place: in the AV's path so many seconds before it, if it drives on
changes_mind(never).  // or so many seconds before it would get into that path; negative: after
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

// Ticks until the AV is level with the own cell, and until one is in its path.
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

// Letter by letter, then it stays; what is in the way is waited for.
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
