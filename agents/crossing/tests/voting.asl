// The elected pedestrian, and what each bidder does then. One of the four pedestrians never bids, so that no
// decision is made before a test asks for it.

{ include("../shared/voting.asl") }

id(2).
pedestrians(4).
bid(5).

@[test]
+!the_lowest_bid_is_elected
  <- +bid(7, 1, 9);
     +bid(7, 2, 5);
     +bid(7, 3, 8);
     ?elected(7, Id);
     !assert_equals(2, Id).

@[test]
+!of_equal_bids_the_lowest_id_is_elected
  <- +bid(7, 3, 5);
     +bid(7, 2, 5);
     +bid(7, 1, 6);
     ?elected(7, Id);
     !assert_equals(2, Id).

@[test]
+!who_abstains_is_not_elected
  <- +bid(7, 1, abstains);
     +bid(7, 2, abstains);
     !assert_false(elected(7, _)).

@[test]
+!the_elected_crosses_and_the_others_walk_on
  <- .add_plan({ +!cross_road <- +crosses }, self, begin);
     .add_plan({ +!keep_walking <- +walks_on }, self, begin);
     +bid(7, 1, 9);
     +bid(7, 2, 5);
     !decide(7);
     !assert_true(crosses);
     !assert_false(walks_on);
     +bid(8, 1, 1);
     +bid(8, 2, 5);
     !decide(8);
     !assert_true(walks_on).

@[test]
+!who_has_a_bid_announces_it
  <- +tick(3);
     .add_plan({ +!announce(Bid) <- +announced(Bid) }, self, begin);
     !vote;
     !assert_true(announced(bid(3, 2, 5))).
