// Checks of a driver before changing lanes, and of the lane ahead.

// Metres to keep to other vehicles, before and behind.
margin(5).

lane_to(left, M) :- lane(N) & M = N - 1.
lane_to(right, M) :- lane(N) & M = N + 1.
lane_beyond(left, M) :- lane(N) & M = N - 2.
lane_beyond(right, M) :- lane(N) & M = N + 2.

// Another agent's vehicle is beside, in the lane on that side; or it is in the lane beyond and could
// change at the same time: the lower number goes first.
occupied(Way) :- lane_to(Way, M) & beside_in(M, _).
occupied(Way) :- lane_beyond(Way, M) & beside_in(M, Id) & id(Own) & Id < Own.

beside_in(M, Id) :-
  vehicle(Id, M, Ahead, _) & vehicle_length(L) & margin(G) & Ahead < L + G & Ahead > -L - G.

// One in the own lane is closer ahead than the margin and what is closed up in two seconds.
held_up :-
  lane(N) & vehicle(_, N, Ahead, V) & Ahead > 0 & speed(Own) & vehicle_length(L) & margin(G) &
  Ahead - L < G + 2 * (Own - V).
