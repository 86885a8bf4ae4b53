// A road as the crossing world gives it: the AV, 3 m wide, in rows 3 and 4 of a lane of rows 2 to 5,
// cruises at 9 m/s, its front is at 1.5 m; a tick is 0.1 s. The pedestrian stands still: actions do nothing.

tick(1).
tick_length(0.1).
cell_length(1.5).
walking_speed(0.1).
grid(12, 66).
pavement(0, 1).
lane(2, 5, forward).
lane(6, 9, back).
pavement(10, 11).
av_rows(3, 4).
av_length(3).
av_speed(0.6).
av(0).
road_end(65).
pedestrians(1).
id(1).

// Replaces goals of the tested program: notes what it wants to do, and fails.
+!exercise_av.
+!get(Place) <- +did(get(Place)); .fail.
+!to(Place)  <- +did(to(Place)); .fail.
+!along(Way) <- +did(along(Way)); .fail.
+!along(Way, _) <- +did(along(Way)); .fail.
-!along(_) <- .fail.
-!along(_, _) <- .fail.
+!wait <- +did(wait); .fail.

+!try(Goal) <- !Goal.
-!try(_).

// The AV's front and speed, and its change in the last tick, in metres and seconds.
+!the_av_is_at(Front, Speed, Change)
  <- -+av_seen(Front, Speed, Change);
     -+driver(Front, Speed, 0);
     -+cruise(9);
     -+risks([]);
     -+home(left).

// The careful driver would have stopped where the AV drives on.
+!a_driver_would_stand_at(Front) <- -+driver(Front, 0, 0).
