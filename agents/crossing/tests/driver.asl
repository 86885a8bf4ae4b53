// The careful driver of shared/driver.asl. From 9 m/s: 1.15 s until braking begins, 10.35 m; then
// 0.6 s in which the deceleration grows, and 0.89 s more.

{ include("shared/road.asl") }
{ include("../shared/stepping.asl") }

@[test]
+!it_stops_within_18_m
  <- !the_av_is_at(20, 9, 0);
     ?way_to_stop(0, Way);
     !assert_equals(18.27, Way, 0.01).

@[test]
+!it_is_imagined_to_stop_where_it_drives
  <- +cruise(9);
     ?drives(0, 3, state(20, 9, 0), 0, state(Front, Speed, _));
     !assert_equals(0, Speed, 0.0001);
     !assert_equals(20 + 18.27, Front, 0.02).

@[test]
+!who_slows_to_4_stops_sooner
  <- !the_av_is_at(20, 4, 0);
     -+cruise(4);
     ?way_to_stop(0, Way);
     !assert_between(Way, 5, 8).

@[test]
+!a_body_beside_the_lane_is_not_over_it
  <- +at(1.5 - 1 / 6, 30);
     !assert_false(in_lane);
     -+at(1.4, 30);
     !assert_true(in_lane);
     !assert_false(in_path).

@[test]
+!a_parked_car_hides_who_is_behind_it
  <- +obstacle(2, 2, 30, 33);
     !assert_true(hidden(30, 4, 51.2));
     !assert_false(hidden(30, 5, 51.2));
     !assert_false(hidden(30, 2.75, 40));
     !assert_false(hidden(52, 4, 55)).

@[test]
+!places_are_mirrored
  <- ?place(beside, left, Left);
     ?place(beside, right, Right);
     !assert_equals(2.75, Left);
     !assert_equals(9.25, Right).

@[test]
+!watching_sees_within_the_cell_where_the_av_is
  <- +at(1, 30);
     !watch;
     -+tick(2);
     !watch;
     ?av_seen(Front, Speed, _);
     !assert_equals(1.5 + 0.9, Front, 0.0001);
     !assert_equals(9, Speed, 0.0001).
