// The ways to go that do not leave the grid and are not blocked (only where something is parked).
// jaywalk: allow-file absent-percept

free(left)    :- at(X, _) & X > 0 & not blocked(left).
free(right)   :- at(X, _) & grid(Rows, _) & X < Rows - 1 & not blocked(right).
free(back)    :- at(_, Y) & Y > 0 & not blocked(back).
free(forward) :- at(_, Y) & grid(_, Cells) & Y < Cells - 1 & not blocked(forward).
