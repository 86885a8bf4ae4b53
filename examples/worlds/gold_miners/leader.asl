// Knows what has been found, and has a job for each miner that asks: the nearest gold, or else a row to search.

next_row(1).  // a miner sees the rows beside its own, too: rows 1, 4, 7 ... show them all

waiting(X, Y) :- found(X, Y) & not given(X, Y).

+found(X, Y)[source(Miner)] : .findall(Other, found(X, Y)[source(Other)], [Miner])
  <- .print(Miner, " has found gold at ", X, ",", Y).

@fetch[atomic]
+?job(X, Y, fetch(U, V)) : waiting(_, _)
  <- .findall(way(D, A, B), waiting(A, B) & D = math.abs(A - X) + math.abs(B - Y), Ways);
     .min(Ways, way(_, U, V));
     +given(U, V).
@search[atomic]
+?job(_, _, search(Row)) : next_row(Row) & gsize(_, _, Height)
  <- -+next_row((Row + 3) mod Height).

+end_of_simulation(_, _) <- .print("All the gold is in the depot.").
