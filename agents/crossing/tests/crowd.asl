// Crowd: who joins whom. The AV is at 1.5 m.

{ include("shared/road.asl") }
{ include("../specialists/crowd.asl") }

av_start(1.5).
stood(1, left, 20).
stood(2, left, 60).
stood(3, right, 61).
stood(4, left, 70).

@[test]
+!the_post_is_far_enough_ahead_of_the_av
  <- ?post(Id);
     !assert_equals(2, Id).

@[test]
+!those_of_its_side_join_it
  <- .findall(Id, joins(Id), Ids);
     !assert_equals([4], Ids).

@[test]
+!it_holds_the_av_up_until_all_have_come
  <- -+id(2);
     +at(1.5 - 1 / 6, 39.5);
     !the_av_is_at(20, 9, 0);
     !try(hold_up);
     !assert_true(did(to(toe)));
     +here(4);
     -did(_);
     !try(hold_up);
     !assert_false(did(to(toe))).
