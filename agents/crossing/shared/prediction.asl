// When a pedestrian who starts to cross the road now would be in the precondition zone, provided
// that the AV keeps its speed. jaywalk: asks rows_to/4

// It is in one of the zone's rows T ticks from now; who is there already will be in the next tick.
in_zone_rows_in(T) :-
  at(X, _) & zone_rows(First, Last) & rows_to(X, First, Last, N) & walking_speed(V) &
  .range(T, math.max(1, math.ceil(N / V)), math.floor((N + Last - First) / V)).

// The zone's cells T ticks from now, and which of them count before the road ends.
zone_in(T, From, To) :-
  av(Y) & av_speed(V) & zone_ahead(First, Last) & From = Y + V * (T - 1) + First &
  To = Y + V * (T - 1) + Last.

meets_av_in(T) :-
  in_zone_rows_in(T) & zone_in(T, From, To) & at(_, Y) & From <= Y & Y <= To & road_end(End) &
  Y <= End.
