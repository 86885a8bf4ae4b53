// How a pedestrian moves: along its pavement, or straight across the road. A step is an action and
// takes a tick. Rows X count from the AV's left, cells Y along its way.

{ include("ways.asl") }

// Which way to set out along the pavement: either (by chance), forward (as the AV drives) or back.
first_way(either).

// The way across the road to where the AV can be met, and beyond.
way_across(right) :- at(X, _) & zone_rows(First, _) & X < First.
way_across(left)  :- at(X, _) & zone_rows(_, Last) & X > Last.

// Rows from row X to the nearest of the rows First to Last.
rows_to(X, First, Last, N) :- N = math.max(0, math.max(First - X, X - Last)).

// The next step across the road: straight, or along past what is parked in the way.
across(Way, Way)     :- free(Way).
across(Way, forward) :- blocked(Way) & free(forward).  // jaywalk: allow absent-percept

+!set_out : first_way(either) <- .random([forward, back], Way); +way(Way); !walk.
+!set_out : first_way(Way)    <- +way(Way); !walk.

// Walk on; where the grid ends or something is parked, turn round.
+!walk : way(Way) & free(Way) <- move(Way).
+!walk : way(forward)         <- -+way(back); move(back).
+!walk                        <- -+way(forward); move(forward).

// Cross to the far edge of the other pavement, or as far as possible, and stay there.
+!cross_road : way_across(Way) <- !cross(Way).

+!cross(Way) : across(Way, Step) <- move(Step); !cross(Way).
+!cross(_).
