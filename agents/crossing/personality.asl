// Personality: steps out when the AV is as many seconds away as it finds acceptable: a bold pedestrian
// right in front of it, a timid one long before it comes; the most timid waits until it has passed.

{ include("shared/alone.asl") }

boldness(0.5).  // from 0, risk-averse, to 1, aggressive

// Seconds until the AV comes to the own cell; negative once it has passed.
arrival(S) :-
  at(_, Y) & av(AvY) & av_speed(V) & V > 0 & tick_length(Tick) & S = (Y - AvY) / V * Tick.

// The time gap that it accepts, in seconds: 2 of the boldest, 10 of the most timid.
accepted_gap(S) :- boldness(B) & S = 10 - 8 * B.

timid :- boldness(0).

time_to_cross :- timid & arrival(S) & S < 0.
time_to_cross :- not timid & arrival(S) & S >= 0 & accepted_gap(Gap) & S <= Gap.
