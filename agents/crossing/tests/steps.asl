// How a pedestrian moves. The goals that act are replaced by plans that note what was wanted.

{ include("../shared/steps.asl") }

grid(10, 66).
zone_rows(4, 6).

@[test]
+!rows_to_the_nearest_row
  <- ?rows_to(1, 4, 6, Left);
     !assert_equals(3, Left);
     ?rows_to(9, 4, 6, Right);
     !assert_equals(3, Right);
     ?rows_to(5, 4, 6, Within);
     !assert_equals(0, Within).

@[test]
+!the_way_across_leads_to_the_zone
  <- +at(0, 30);
     ?way_across(FromLeft);
     !assert_equals(right, FromLeft);
     -+at(9, 30);
     ?way_across(FromRight);
     !assert_equals(left, FromRight).

@[test]
+!no_way_leaves_the_grid
  <- +at(0, 0);
     .findall(Way, free(Way), Ways);
     !assert_equals([right, forward], Ways);
     -+at(9, 65);
     .findall(Way, free(Way), Others);
     !assert_equals([left, back], Others).

@[test]
+!who_sets_out_forward_walks_forward
  <- .add_plan({ +!walk <- +walked }, self, begin);
     -+first_way(forward);
     !set_out;
     !assert_true(way(forward));
     !assert_true(walked).

@[test]
+!who_sets_out_either_way_takes_one_of_both
  <- .add_plan({ +!walk }, self, begin);
     !set_out;
     ?way(Way);
     !assert_contains([forward, back], Way).

@[test]
+!who_has_crossed_stays
  <- .add_plan({ +!cross(Way) <- +crossed(Way) }, self, begin);
     +at(1, 20);
     !cross_road;
     !assert_true(crossed(right));
     !assert_equals(1, .count(crossed(_))).

@[test]
+!no_way_leads_into_what_blocks_it
  <- +at(1, 30);
     +blocked(right);
     .findall(Way, free(Way), Ways);
     !assert_equals([left, back, forward], Ways).

@[test]
+!a_step_across_leads_past_what_blocks_it
  <- +at(1, 30);
     ?across(right, Straight);
     !assert_equals(right, Straight);
     +blocked(right);
     ?across(right, Along);
     !assert_equals(forward, Along);
     +blocked(forward);
     !assert_false(across(right, _)).
