// Stall: in the middle of the AV's path.

{ include("shared/road.asl") }
{ include("../specialists/stall.asl") }

at(3.5, 30).

@[test]
+!it_stands_while_the_av_waits
  <- !the_av_is_at(45, 0, 0);
     +stopped(-3);
     !try(stall);
     !assert_true(did(wait)).

@[test]
+!it_goes_on_when_it_has_stood_long_enough
  <- !the_av_is_at(45, 0, 0);
     +stopped(-21);
     !try(stall);
     !assert_true(did(get(out))).

@[test]
+!it_steps_out_in_good_time
  <- -+at(1.5 - 1 / 6, 30);
     !the_av_is_at(5, 9, 0);
     !try(wait_for_the_av(4));
     !assert_true(did(wait));
     -did(_);
     !the_av_is_at(10, 9, 0);
     !try(wait_for_the_av(4));
     !assert_false(did(wait)).
