// Sprint: a foot in the lane, 45.5 m along the road.

{ include("shared/road.asl") }
{ include("../specialists/sprint.asl") }

at(1.4, 30).

@[test]
+!it_dawdles_while_there_is_time
  <- !the_av_is_at(28, 9, 0);
     !try(dawdle);
     !assert_true(did(to(middle))).

@[test]
+!it_runs_when_that_is_the_last_moment
  <- !the_av_is_at(36, 9, 0);
     !a_driver_would_stand_at(20);
     !try(dawdle);
     !assert_true(pace(3));
     !assert_true(did(get(middle))).

@[test]
+!it_stands_in_the_path_of_an_av_that_comes
  <- -+at(3, 30);
     !the_av_is_at(36, 9, 0);
     !try(dawdle);
     !assert_true(did(wait)).
