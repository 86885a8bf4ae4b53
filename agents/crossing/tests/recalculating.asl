// Recalculating: it does not wait for ever.

{ include("shared/road.asl") }
{ include("../recalculating.asl") }

zone_rows(2, 5).
zone_ahead(1, 6).
cruise(0.6).
across(right).

@[test]
+!it_notes_when_the_av_first_slows
  <- !assert_false(av_slows);
     -+av_speed(0.5);
     !assert_true(av_slows);
     +slowed_in(7);
     !assert_false(av_slows).

@[test]
+!it_crosses_when_its_patience_ends
  <- .add_plan({ +!cross(_) <- +crossed }, self, begin);
     +at(1, 30);
     +slowed_in(0);
     !assert_false(out_of_patience);
     -+tick(201);
     !seek_av;
     !assert_true(crossed).
