// When crossing now leads into the precondition zone. The AV is in cell 10 and drives one cell a
// tick; the zone is rows 4 to 6, from 3 to 5 cells before it; the pavement is row 2 and below.

{ include("../shared/steps.asl") }
{ include("../shared/prediction.asl") }

zone_rows(4, 6).
zone_ahead(3, 5).
av(10).
av_speed(1).
walking_speed(1).
road_end(60).

@[test]
+!the_rows_of_the_zone_are_reached_one_a_tick
  <- +at(1, 20);
     .findall(T, in_zone_rows_in(T), Ticks);
     !assert_equals([3, 4, 5], Ticks).

@[test]
+!the_zone_moves_with_the_av
  <- ?zone_in(1, From, To);
     !assert_equals(13, From);
     !assert_equals(15, To);
     ?zone_in(4, Later, _);
     !assert_equals(16, Later).

@[test]
+!who_is_where_the_zone_will_be_meets_the_av
  <- +at(1, 15);
     !assert_true(meets_av_in(3)).

@[test]
+!who_is_too_far_ahead_does_not
  <- +at(1, 30);
     !assert_false(meets_av_in(_)).

@[test]
+!nobody_meets_the_av_beyond_the_end_of_the_road
  <- +at(1, 15);
     -+road_end(14);
     !assert_false(meets_av_in(_)).
