// Whom drivers look out for: in lane 2 of 3, at 30 m/s, in a vehicle of 4.5 m.

{ include("../shared/looking.asl") }

id(2).
lane(2).
speed(30).
vehicle_length(4.5).

@[test]
+!a_lane_is_free_where_nobody_is_beside
  <- +vehicle(1, 1, 9.5, 30);
     +vehicle(3, 3, -9.5, 30);
     !assert_false(occupied(left));
     !assert_false(occupied(right)).

@[test]
+!a_lane_is_occupied_within_the_margin
  <- +vehicle(1, 1, 9.4, 30);
     +vehicle(3, 3, -9.4, 30);
     !assert_true(occupied(left));
     !assert_true(occupied(right)).

@[test]
+!the_lower_number_goes_first_into_the_lane_between
  <- -+lane(1);
     +vehicle(3, 3, 0, 30);
     !assert_false(occupied(right));
     +vehicle(1, 3, 0, 30);
     !assert_true(occupied(right)).

@[test]
+!whoever_is_slower_ahead_holds_up
  <- +vehicle(1, 2, 29.5, 20);
     !assert_false(held_up);
     -+vehicle(1, 2, 29.4, 20);
     !assert_true(held_up).
