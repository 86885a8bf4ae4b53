// Cut in: overtake the AV in the lane beside its own, change into its lane close before its front and slow down there.

{ include("shared/looking.asl") }

// Metres between the AV's front and the own rear at which the change of lanes begins.
gap(8).
// Metres per second by which it is slower then than the AV.
slower(5).

// Where the own rear is, counted ahead from the AV's front.
lead(M) :- av(_, Ahead, _) & vehicle_length(L) & M = -Ahead - L.
beside(left) :- lane(N) & av(A, _, _) & A = N - 1.
beside(right) :- lane(N) & av(A, _, _) & A = N + 1.
far_lane(left) :- lane(N) & av(A, _, _) & A < N - 1.
far_lane(right) :- lane(N) & av(A, _, _) & A > N + 1.

+tick(_) <- !drive.

+!drive : held_up <- brake(4).
+!drive : changing(_) <- keep.
+!drive : lane(N) & av(N, Ahead, Own) & Ahead < 0 & slower(By) & speed(V) & V > Own - By
  <- brake(3).
+!drive : far_lane(Way) & not occupied(Way) <- change_lane(Way).
+!drive : beside(Way) & not occupied(Way) & lead(M) & gap(G) & M >= G & M < 3 * G
  <- change_lane(Way).
// The other way round: let the AV come nearer.
+!drive : beside(_) & lead(M) & gap(G) & M >= 3 * G & speed(V) & av(_, _, Own) & V > Own - 3
  <- brake(2).
+!drive : beside(_) & lead(M) & gap(G) & M < G & speed(V) & av(_, _, Own) & V < Own + 6
  <- accelerate(2).
+!drive <- keep.
-!drive <- true.
