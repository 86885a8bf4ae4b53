// Shadow: a car is parked 45 to 51 m along the road.

{ include("shared/road.asl") }
{ include("../specialists/shadow.asl") }

obstacle(2, 2, 30, 33).

@[test]
+!it_hides_at_the_far_end
  <- +at(1, 36);
     !the_av_is_at(1.5, 9, 0);
     ?hideout(_, Y);
     !assert_equals(51.5, Y).

@[test]
+!there_is_time_to_walk_there_or_not
  <- +at(1, 33);
     !the_av_is_at(1.5, 9, 0);
     !assert_true(in_time(51.5));
     !the_av_is_at(20, 9, 0);
     !assert_false(in_time(51.5)).

@[test]
+!it_does_not_go_far
  <- +at(1, 55);
     !the_av_is_at(1.5, 9, 0);
     !assert_false(hideout(_, _)).

@[test]
+!there_is_no_hideout_on_the_other_side
  <- +at(10, 36);
     !the_av_is_at(1.5, 9, 0);
     !assert_false(hideout(_, _)).

@[test]
+!the_driver_sees_it_as_it_comes_out
  <- +at(2.3, 33.8);
     !the_av_is_at(20, 9, 0);
     ?emerges(left, X);
     !assert_between(X, 4.3, 4.5).
