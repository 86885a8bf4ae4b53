// By features: crosses when the AV is near, and knows of the world only what lies around it: no map,
// no rows, so that it can walk in a world of any size.

!exercise_av.

reach(15).  // cells ahead of the AV at which it steps out

+!exercise_av <- .random([forward, back], Way); +way(Way); !walk.

time_to_cross(Side) :-
  av_offset(Offset) & Offset <= 0 & reach(Reach) & -Offset < Reach & kerb(Side, Steps) &
  not (kerb(_, Fewer) & Fewer < Steps).

passable(Way) :- ground(Way, Kind) & Kind \== blocked & not blocked(Way).  // jaywalk: allow absent-percept

+!walk : time_to_cross(Side)                   <- !cross(Side).
+!walk : way(Way) & ground(Way, pavement)      <- move(Way); !walk.
+!walk : way(forward) & ground(back, pavement) <- -+way(back); move(back); !walk.
+!walk : way(back) & ground(forward, pavement) <- -+way(forward); move(forward); !walk.
+!walk                                         <- stay; !walk.

+!cross(Side) : passable(Side) <- move(Side); !cross(Side).
+!cross(_).
