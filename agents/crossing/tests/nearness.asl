// How far away the AV is. Percepts are given as beliefs: a road whose lane of the AV is rows 4 to 6.

{ include("../shared/steps.asl") }
{ include("../shared/nearness.asl") }

lane(4, 6, forward).
av_rows(5, 5).
av(10).

@[test]
+!distance_counts_cells_and_rows
  <- +at(1, 4);
     ?distance_to_av(D);
     !assert_equals(6 + 3, D).

@[test]
+!distance_within_the_lane_is_along_it
  <- +at(5, 13);
     ?distance_to_av(D);
     !assert_equals(3, D).

@[test]
+!an_av_that_has_passed_is_as_near
  <- +at(6, 8);
     ?distance_to_av(Behind);
     -+at(6, 12);
     ?distance_to_av(Ahead);
     !assert_equals(Ahead, Behind).

@[test]
+!the_radius_itself_is_not_near
  <- !assert_true(near(14));
     !assert_false(near(15));
     !assert_false(near(16)).

@[test]
+!the_radius_is_near_if_it_is_included
  <- -+radius_limit(inclusive);
     !assert_true(near(15));
     !assert_false(near(16)).
