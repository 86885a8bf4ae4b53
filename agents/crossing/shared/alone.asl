// A pedestrian who acts alone: it walks along its pavement until it is time to cross the road. When
// that is, the program that includes this file says by its rules. jaywalk: asks time_to_cross/0

{ include("steps.asl") }

!exercise_av.

+!exercise_av <- !set_out; !walk_until_time; !cross_road.

+!walk_until_time : time_to_cross.
+!walk_until_time <- !walk; !walk_until_time.
