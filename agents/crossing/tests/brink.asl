// Brink: stepping out at 9 m/s is avoided from 18.27 m on; a tick later the AV is 0.9 m nearer.

{ include("shared/road.asl") }
{ include("../specialists/brink.asl") }

at(1.5 - 1 / 6, 30).  // beside the lane, 45.5 m along the road

@[test]
+!it_moves_to_where_a_tick_begins_at_the_last_moment
  <- !the_av_is_at(26, 9, 0);
     ?slack(M);
     !assert_equals(45.5 - 26 - 18.27 - 0.1 - 0.9, M, 0.01);
     !try(wait_for_the_brink);
     !assert_true(did(along(back))).

@[test]
+!it_waits_while_the_driver_could_stop_a_tick_later_too
  <- !the_av_is_at(45.5 - 18.27 - 0.11 - 1.8, 9, 0);
     !try(wait_for_the_brink);
     !assert_true(did(wait)).

@[test]
+!it_steps_out_when_that_is_the_last_moment
  <- !the_av_is_at(27, 9, 0);
     !try(wait_for_the_brink);
     !assert_false(did(wait)).

@[test]
+!it_stays_where_nobody_could_avoid_it
  <- !the_av_is_at(28, 9, 0);
     !try(wait_for_the_brink);
     !assert_true(did(wait)).

@[test]
+!it_goes_nearer_to_a_slow_av
  <- !the_av_is_at(27, 4, 0);
     !assert_false(on_the_brink);
     !the_av_is_at(36.5, 4, 0);
     !assert_true(on_the_brink).

@[test]
+!it_does_not_move_beside_a_parked_car
  <- +obstacle(2, 2, 26, 29);
     !the_av_is_at(15.5, 9, 0);
     ?slack(M);
     !assert_true(M > 0.5);
     !try(wait_for_the_brink);
     !assert_false(did(along(back)));
     !assert_true(did(wait)).
