// Learner: in every tick one of a driver's actions, which one is learned (jaywalk learn). Without a policy all that
// are possible are as probable as each other.

{ include("shared/looking.asl") }

!drive.

+!drive <- !act; !drive.

toward(left) :- lane(N) & av(A, _, _) & A < N.
toward(right) :- lane(N) & av(A, _, _) & A > N.

@change[learned(act)] +!act : not changing(_) & toward(Way) & not occupied(Way) <- change_lane(Way).
@accelerate[learned(act)] +!act <- accelerate(2).
@brake[learned(act)] +!act <- brake(2).
@keep[learned(act)] +!act <- keep.

// Lanes away from the AV's, and by how many metres the own rear is before the AV's front.
observation(act, [Away, Lead]) :-
  lane(N) & av(A, Ahead, _) & vehicle_length(L) & Away = N - A & Lead = -Ahead - L.
