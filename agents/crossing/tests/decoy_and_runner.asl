// Decoy and runner: who is which.

{ include("shared/road.asl") }
{ include("../specialists/decoy_and_runner.asl") }

stood(1, left, 50).
stood(2, right, 40).
stood(3, left, 60).

@[test]
+!the_nearest_to_the_av_is_the_decoy
  <- !assert_false(decoy);
     -+id(2);
     !assert_true(decoy).

@[test]
+!it_stands_short_of_the_next_one
  <- -+id(2);
     ?runner(Y);
     !assert_equals(50, Y).

@[test]
+!it_draws_the_braking_until_the_av_slows
  <- +at(1.4, 30);
     !the_av_is_at(20, 9, 0);
     !try(wait_until_it_slows);
     !assert_true(did(wait));
     -did(_);
     !the_av_is_at(20, 8, -0.6);
     !try(wait_until_it_slows);
     !assert_false(did(wait)).
