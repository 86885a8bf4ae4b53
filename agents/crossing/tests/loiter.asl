// Loiter: with a foot in the lane, 45.5 m along the road.

{ include("shared/road.asl") }
{ include("../specialists/loiter.asl") }

at(1.4, 30).

@[test]
+!it_waits_while_the_av_is_far
  <- !the_av_is_at(10, 9, 0);
     !try(loiter);
     !assert_true(did(wait)).

@[test]
+!it_sets_out_when_the_av_is_about_to_pass
  <- !the_av_is_at(37, 9, 0);
     !a_driver_would_stand_at(20);
     !try(loiter);
     !assert_true(did(get(middle))).

@[test]
+!it_tries_the_other_side_when_the_av_has_stopped
  <- +tick(1);
     !the_av_is_at(28, 0, 0);
     !try(loiter);
     !assert_true(did(get(tip))).

@[test]
+!it_crosses_when_the_av_waits_there_too
  <- +tick(41);
     +came_over(0);
     !the_av_is_at(28, 0, 0);
     !try(loiter);
     !assert_true(did(get(out))).
