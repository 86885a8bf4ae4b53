// Overtake: pass the AV and return to its lane so far ahead that the AV need not brake.

{ include("shared/looking.asl") }

// Seconds of the AV's drive between its front and the own rear.
distance(2).

lead(M) :- av(_, Ahead, _) & vehicle_length(L) & M = -Ahead - L.
wanted(M) :- distance(S) & av(_, _, V) & M = S * V.
beside(left) :- lane(N) & av(A, _, _) & A = N - 1.
beside(right) :- lane(N) & av(A, _, _) & A = N + 1.

+tick(_) <- !drive.

+!drive : held_up <- brake(4).
+!drive : changing(_) <- keep.
+!drive : beside(Way) & not occupied(Way) & lead(M) & wanted(W) & M >= W <- change_lane(Way).
+!drive : speed(V) & av(_, _, Own) & V < Own + 6 <- accelerate(2).
+!drive <- keep.
-!drive <- true.
