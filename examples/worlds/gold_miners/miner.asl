// Asks the leader what to do, does it, and tells the leader of gold that it sees on its way.

move(left, -1, 0).
move(right, 1, 0).
move(up, 0, -1).
move(down, 0, 1).

visits(X, Y, N) :- been(X, Y, N).
visits(X, Y, 0) :- not been(X, Y, _).

// A step to the target should bring the miner nearer, and rather to where it has not been on its way.
step(Cost, Move, TargetX, TargetY) :-
  pos(X, Y) & move(Move, Right, Down) & U = X + Right & V = Y + Down & gsize(_, Width, Height) &
  U >= 0 & U < Width & V >= 0 & V < Height & not cell(U, V, obstacle) & not cell(U, V, ally) &
  visits(U, V, N) & Cost = math.abs(TargetX - U) + math.abs(TargetY - V) + 4 * N.

!work.

+!work : pos(X, Y)
  <- .send(leader, askOne, job(X, Y, _), job(_, _, Job));
     !Job;
     !work.
+!work <- .wait(pos(_, _)); !work.

+cell(X, Y, gold) <- .send(leader, tell, found(X, Y)).

+!fetch(X, Y) : depot(_, DepotX, DepotY)
  <- !walk(X, Y);
     do(pick);
     !walk(DepotX, DepotY);
     do(drop).

+!search(Row) : pos(X, _) & gsize(_, Width, _) & X < Width / 2
  <- !walk(1, Row);
     !walk(Width - 2, Row).
+!search(Row) : gsize(_, Width, _)
  <- !walk(Width - 2, Row);
     !walk(1, Row).

+!walk(X, Y) <- .abolish(been(_, _, _)); !go(X, Y).

+!go(X, Y) : pos(X, Y).
+!go(X, Y) : pos(A, B) & visits(A, B, N)
  <- -been(A, B, N);
     +been(A, B, N + 1);
     .findall(option(Cost, Move), step(Cost, Move, X, Y), Options);
     !take(Options);
     !go(X, Y).

+!take([]) <- do(skip).  // others stand in the way
+!take(Options) <- .min(Options, option(_, Move)); do(Move).
