// Feint: out into the lane, back when the AV slows, and out again on the brink when it picks up speed;
// again and again.

{ include("../shared/stepping.asl") }

!exercise_av.

+!exercise_av <- !set_out_across; !come_into_view; !get(beside); !wait_for_the_av(4.4); !begin.

// Where a driver that slows would have no room left, it steps out at the last moment first.
+!begin : spare(0, M) & M > 14 <- !dart; !feint.
+!begin                        <- !feint.

// Back as soon as it slows; if it does not, it is met.
+!dart : slows | stands | gone <- !get(beside).
+!dart : about_to_pass         <- !get(middle); !stay_there.
+!dart                         <- !to(toe); !dart.

+!feint : on_the_brink <- !get(middle); !stay_there.
+!feint                <- !wait; !feint.

// In its path while it comes; out again when it stands, with some way left to pick up speed.
+!stay_there : not stands <- !wait; !stay_there.
+!stay_there              <- !get(brim); !make_room; !get(beside); !feint.

+!make_room : stands & gap(M) & (M < 4 | on_the_zebra(_)) <- !along(forward); !make_room.
+!make_room.
