// The ways to go that do not leave the grid.

free(left)    :- at(X, _) & X > 0.
free(right)   :- at(X, _) & grid(Rows, _) & X < Rows - 1.
free(back)    :- at(_, Y) & Y > 0.
free(forward) :- at(_, Y) & grid(_, Cells) & Y < Cells - 1.
