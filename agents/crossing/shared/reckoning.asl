// Reckoning in seconds: what holds for ticks and steps of any length. jaywalk: asks rows_to/4

// Seconds that walking N cells takes; a step that is begun takes its tick.
seconds_to_walk(N, S) :- ticks_to_walk(N, T) & tick_length(Tick) & S = T * Tick.
ticks_to_walk(N, T)   :- walking_speed(V) & T = math.ceil(N / V - 0.000001).

// Seconds until the nearest of the rows First to Last is reached.
seconds_to_rows(First, Last, S) :- at(X, _) & rows_to(X, First, Last, N) & seconds_to_walk(N, S).

// The cell of the AV S seconds from now, provided that it keeps its speed.
av_in(S, Y) :- av(Now) & av_speed(V) & tick_length(Tick) & Y = Now + V * S / Tick.
