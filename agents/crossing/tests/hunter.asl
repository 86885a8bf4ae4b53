// Hunter: what it wants as the AV now drives.

{ include("shared/road.asl") }
{ include("../hunter.asl") }

trials([far, near, beyond]).

@[test]
+!it_lures_an_av_that_has_room_to_stop
  <- +at(1.5 - 1 / 6, 50);
     !the_av_is_at(38, 9, 0);
     ?desire(Desire);
     !assert_equals(come_on, Desire).

@[test]
+!it_does_not_lure_an_av_that_is_far
  <- +at(1.5 - 1 / 6, 50);
     !the_av_is_at(10, 9, 0);
     ?desire(Desire);
     !assert_equals(be_ready, Desire).

@[test]
+!it_steps_out_on_the_brink
  <- +at(1.5 - 1 / 6, 30);
     !the_av_is_at(27, 9, 0);
     ?desire(Desire);
     !assert_equals(step_out, Desire).

@[test]
+!it_tries_the_patience_of_an_av_that_stands
  <- +at(3.5, 30);
     !the_av_is_at(44, 0, 0);
     ?desire(Desire);
     !assert_equals(try(far), Desire).

@[test]
+!it_draws_on_an_av_whose_patience_it_has_tried
  <- +at(3.5, 30);
     -+trials([]);
     !the_av_is_at(44, 0, 0);
     ?desire(Desire);
     !assert_equals(draw_on, Desire).

@[test]
+!it_is_met_by_an_av_that_drives_on
  <- +at(2.1, 30);
     !the_av_is_at(42, 9, 0);
     !a_driver_would_stand_at(20);
     ?desire(Desire);
     !assert_equals(meet, Desire).

@[test]
+!it_is_out_of_the_lane_again_when_the_av_reacts_as_a_driver
  <- +at(1.4, 30);
     !the_av_is_at(20, 7, -0.7);
     ?desire(Desire);
     !assert_equals(remember(as_a_driver), Desire).

@[test]
+!it_waits_for_an_av_that_reacts_late_to_leave_the_driver_behind
  <- +at(1.4, 30);
     !the_av_is_at(22, 8, -0.3);
     !a_driver_would_stand_at(20);
     ?desire(Desire);
     !assert_equals(come_on, Desire);
     !the_av_is_at(23, 7, -0.3);
     !a_driver_would_stand_at(20);
     ?desire(Then);
     !assert_equals(remember(otherwise), Then).

@[test]
+!it_remembers_how_the_av_reacted
  <- +at(1.4, 30);
     !the_av_is_at(20, 7, -0.7);
     !try(remember(as_a_driver));
     !assert_true(reacted(as_a_driver)).

@[test]
+!it_leaves_luring_to_whom_the_av_comes_to_first
  <- +at(1.5 - 1 / 6, 50);
     +road_user(2, pedestrian, 1, 45, 0, 0);
     !the_av_is_at(38, 9, 0);
     ?desire(Desire);
     !assert_equals(be_ready, Desire).

@[test]
+!it_lets_the_av_go_after_two_tries
  <- +at(1.5 - 1 / 6, 30);
     +drawing;
     !rest;
     !the_av_is_at(27, 9, 0);
     ?desire(Desire);
     !assert_equals(step_out, Desire);
     +drawing;
     !rest;
     ?desire(Then);
     !assert_equals(let_go, Then).

@[test]
+!it_puts_a_foot_in_the_lane_of_an_av_that_leaves
  <- +at(1.5 - 1 / 6, 30);
     +draws(2);
     !the_av_is_at(45.2, 1, 0.2);
     !try(desires);
     !assert_true(did(to(toe))).
+!desires : desire(Desire) <- !Desire.

@[test]
+!it_walks_into_an_av_that_stands_beside_it_when_a_driver_would_be_gone
  <- +at(1.5 - 1 / 6, 30);
     +draws(2);
     !the_av_is_at(46, 0, 0);
     ?desire(Desire);
     !assert_equals(graze, Desire);
     !a_driver_would_stand_at(60);
     ?desire(Then);
     !assert_equals(meet, Then).

@[test]
+!it_does_not_go_over_to_a_parked_car
  <- +at(3.5, 30);
     +obstacle(4, 4, 30, 32);
     -+trials([beyond]);
     !the_av_is_at(44, 0, 0);
     ?desire(Desire);
     !assert_equals(draw_on, Desire).

@[test]
+!it_leaves_the_lane_where_a_parked_car_ends_its_way_along_it
  <- +at(2.3, 30.3);
     +obstacle(2, 2, 31, 33);
     +drawing;
     !the_av_is_at(44, 0, 0);
     !try(draw_on);
     !assert_false(did(along(forward))).

@[test]
+!it_draws_the_av_along_a_free_lane
  <- +at(2.3, 30);
     +drawing;
     !the_av_is_at(44, 0, 0);
     !try(draw_on);
     !assert_true(did(along(forward))).

@[test]
+!it_outlasts_the_driver_before_an_av_that_stands_back
  <- +at(4.9, 30);
     -+trials([]);
     !the_av_is_at(43.5, 0, 0);
     !a_driver_would_stand_at(45.4);
     ?desire(Desire);
     !assert_equals(outlast, Desire);
     !try(outlast);
     !assert_true(did(along(back)));
     !a_driver_would_stand_at(45.6);
     ?desire(Then);
     !assert_equals(outlast, Then);
     !try(outlast);
     !assert_true(did(wait));
     !a_driver_would_stand_at(60);
     ?desire(Last);
     !assert_equals(be_ready, Last).

@[test]
+!it_walks_into_an_av_that_it_let_go_when_a_driver_would_be_gone
  <- +at(1.5 - 1 / 6, 30);
     +draws(2);
     !the_av_is_at(48, 1, 0.2);
     ?desire(Desire);
     !assert_equals(graze, Desire);
     !a_driver_would_stand_at(80);
     ?desire(Then);
     !assert_equals(step_out, Then).

@[test]
+!it_puts_a_foot_in_the_lane_when_a_driver_cannot_stop_any_more
  <- +at(1.5 - 1 / 6, 30);
     !the_av_is_at(33, 9, 0);
     ?desire(Desire);
     !assert_equals(graze, Desire).

@[test]
+!it_walks_into_an_av_that_passes_where_a_driver_waits
  <- +at(4.9, 30);
     !the_av_is_at(46, 1, 0.2);
     !a_driver_would_stand_at(45.4);
     ?desire(Desire);
     !assert_equals(meet, Desire).

@[test]
+!it_does_not_wait_where_the_road_ends_before_the_av_has_passed
  <- +at(1.5 - 1 / 6, 64);
     !the_av_is_at(20, 9, 0);
     !try(be_ready);
     !assert_true(did(along(back))).
