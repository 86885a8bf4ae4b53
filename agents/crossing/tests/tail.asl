// Tail: beside the AV's path, in its lane.

{ include("shared/road.asl") }
{ include("../specialists/tail.asl") }

at(2.1, 30).

@[test]
+!it_walks_against_the_av
  <- !the_av_is_at(20, 9, 0);
     !try(tail);
     !assert_true(did(along(back))).

@[test]
+!it_walks_on_while_the_av_brakes
  <- !the_av_is_at(20, 6, -0.7);
     !try(tail);
     !assert_true(did(along(back))).

@[test]
+!it_turns_round_where_a_driver_could_hardly_stop
  <- !the_av_is_at(20, 9, 0);
     !a_driver_would_stand_at(44.5);
     !try(tail);
     !assert_true(did(along(forward))).

@[test]
+!it_turns_in_when_the_av_is_about_to_pass
  <- !the_av_is_at(42, 9, 0);
     !a_driver_would_stand_at(20);
     !try(tail);
     !assert_true(did(get(middle))).
