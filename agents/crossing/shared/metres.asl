// The road and this pedestrian in metres and seconds, whatever the lengths of cell and tick. X counts
// from the left end of the AV's rows, Y along the AV's way.

body(0.5).  // the width and the length of a pedestrian
pace(1.5).  // m/s, how fast to walk where nothing is said of it

x(M)    :- at(X, _) & cell_length(C) & M = (X + 0.5) * C.
y(M)    :- at(_, Y) & cell_length(C) & M = (Y + 0.5) * C.
near(M) :- at(_, Y) & cell_length(C) & body(B) & M = (Y + 0.5) * C - B / 2.
far(M)  :- near(N) & body(B) & M = N + B.

in_metres(First, Last, From, To) :- cell_length(C) & From = First * C & To = (Last + 1) * C.
path(From, To) :- av_rows(First, Last) & in_metres(First, Last, From, To).
av_lane(From, To) :-
  av_rows(Row, _) & lane(First, Last, _) & First <= Row & Row <= Last &
  in_metres(First, Last, From, To).

// A body whose middle is at X is over the strip From to To; touching its edge alone does not count.
over(X, From, To) :- body(B) & X + B / 2 > From + 0.000001 & X - B / 2 < To - 0.000001.
in_lane :- x(X) & av_lane(From, To) & over(X, From, To).
in_path :- x(X) & path(From, To) & over(X, From, To).

// The side of the AV's path on which this pedestrian is.
side(left)  :- x(X) & path(From, To) & X < (From + To) / 2.
side(right) :- not side(left).

// Places across the road, seen from a side: beside the lane; a foot in it; beside the AV's path; in
// its middle; in its other half; beyond it; a foot left in the lane; out of it on the other side.
place(beside, left, X) :- av_lane(From, _) & body(B) & X = From - B / 2.
place(toe, left, X)    :- av_lane(From, _) & body(B) & X = From - B / 2 + 0.1.
place(brim, left, X)   :- path(From, _) & body(B) & X = From - B / 2 - 0.35.
place(near, left, X)   :- path(From, To) & X = (From + To) / 2 - 0.6.
place(middle, left, X) :- path(From, To) & X = (From + To) / 2.
place(far, left, X)    :- path(From, To) & X = (From + To) / 2 + 0.6.
place(beyond, left, X) :- path(_, To) & body(B) & X = To + B / 2 + 0.35.
place(tip, left, X)    :- av_lane(_, To) & body(B) & X = To + B / 2 - 0.1.
place(out, left, X)    :- av_lane(_, To) & body(B) & X = To + B / 2.
place(Name, right, X)  :- mirrored(Name, Other) & place(Other, left, X).

mirrored(beside, out).
mirrored(brim, beyond).
mirrored(near, far).
mirrored(middle, middle).
mirrored(far, near).
mirrored(beyond, brim).
mirrored(out, beside).
mirrored(toe, tip).
mirrored(tip, toe).
