// Hunter: what it wants as the AV now drives.

{ include("shared/road.asl") }
{ include("../hunter.asl") }

trials([far, near, beyond]).

@[test]
+!it_provokes_an_av_that_is_far
  <- +at(1.5 - 1 / 6, 50);
     !the_av_is_at(10, 9, 0);
     ?desire(Desire);
     !assert_equals(provoke, Desire).

@[test]
+!it_steps_out_on_the_brink
  <- +at(1.5 - 1 / 6, 30);
     !the_av_is_at(27, 9, 0);
     ?desire(Desire);
     !assert_equals(step_out, Desire).

@[test]
+!it_tries_the_patience_of_an_av_that_stands
  <- +at(3.5, 30);
     !the_av_is_at(44, 0, 0);
     ?desire(Desire);
     !assert_equals(try(far), Desire).

@[test]
+!it_draws_on_an_av_whose_patience_it_has_tried
  <- +at(3.5, 30);
     -+trials([]);
     !the_av_is_at(44, 0, 0);
     ?desire(Desire);
     !assert_equals(draw_on, Desire).

@[test]
+!it_is_met_by_an_av_that_drives_on
  <- +at(2.1, 30);
     !the_av_is_at(42, 9, 0);
     !a_driver_would_stand_at(20);
     ?desire(Desire);
     !assert_equals(meet, Desire).

@[test]
+!it_remembers_that_the_av_reacted
  <- +at(2.1, 30);
     !the_av_is_at(20, 7, -0.7);
     !try(come_on);
     !assert_true(reacts_to(walking)).
