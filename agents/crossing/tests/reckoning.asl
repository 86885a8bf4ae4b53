// Seconds and cells, at the case study's ticks of 1 s and at ticks of 0.1 s.

{ include("../shared/steps.asl") }
{ include("../shared/reckoning.asl") }

at(1, 20).
av(10).

+!long_ticks  <- +tick_length(1); +walking_speed(1); +av_speed(6).
+!short_ticks <- +tick_length(0.1); +walking_speed(0.1); +av_speed(0.6).

@[test]
+!walking_takes_as_long_at_any_tick
  <- !long_ticks;
     ?seconds_to_rows(4, 6, Long);
     !assert_equals(3, Long);
     .abolish(tick_length(_));
     .abolish(walking_speed(_));
     !short_ticks;
     ?seconds_to_rows(4, 6, Short);
     !assert_equals(3, Short, 0.000001).

@[test]
+!a_step_that_is_begun_takes_its_tick
  <- +tick_length(0.5);
     +walking_speed(0.75);
     ?seconds_to_walk(1, S);
     !assert_equals(1, S).

@[test]
+!the_av_comes_as_far_at_any_tick
  <- !long_ticks;
     ?av_in(3, Long);
     !assert_equals(28, Long);
     .abolish(tick_length(_));
     .abolish(av_speed(_));
     !short_ticks;
     ?av_in(3, Short);
     !assert_equals(28, Short, 0.000001).
