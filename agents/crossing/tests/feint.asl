// Feint: out, back, and out again.

{ include("shared/road.asl") }
{ include("../specialists/feint.asl") }

at(1.4, 30).  // a foot in the lane

@[test]
+!it_goes_back_when_the_av_slows
  <- !the_av_is_at(20, 7, -0.5);
     !try(dart);
     !assert_true(did(get(beside))).

@[test]
+!it_is_met_by_an_av_that_does_not_slow
  <- !the_av_is_at(37, 9, 0);
     !a_driver_would_stand_at(20);
     !try(dart);
     !assert_true(did(get(middle))).

@[test]
+!it_stays_in_the_path_of_an_av_that_comes
  <- -+at(3.5, 30);
     !the_av_is_at(40, 5, -0.5);
     !try(stay_there);
     !assert_true(did(wait)).

@[test]
+!it_makes_room_for_an_av_that_stands
  <- -+at(2, 30);
     !the_av_is_at(45, 0, 0);
     !try(make_room);
     !assert_true(did(along(forward))).
