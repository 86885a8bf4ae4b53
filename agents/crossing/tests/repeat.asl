// Repeat: having crossed, on the right of the lane.

{ include("shared/road.asl") }
{ include("../repeat.asl") }

at(5.5 + 1 / 6, 30).

@[test]
+!it_waits_beside_an_av_that_is_too_near
  <- !the_av_is_at(44, 3, 0.2);
     !try(cross_again);
     !assert_true(did(wait)).

@[test]
+!it_turns_round_on_the_brink
  <- !the_av_is_at(27, 9, 0);
     !try(cross_again);
     !assert_true(home(right));
     !assert_true(did(get(out))).
