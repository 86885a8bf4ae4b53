// Crowd: those of one side merge into a group beside one of them, the post, who holds the AV up with a
// foot in its lane until all have come. Then they split: the post steps back and stays, the others
// step out at the last moment and cross. A pedestrian that is alone does that at once.

{ include("../shared/stepping.asl") }
{ include("../shared/company.asl") }

!exercise_av.

+!exercise_av <- !tell_where_i_stand; !set_out_across; !begin.

+!begin : id(Me) & joins(Me) <- !join; !tell_the_post; !split.
+!begin : id(Me) & post(Me)  <- !get(beside); !hold_up; !get(beside); !stay_behind.
+!begin                      <- !get(beside); !split.

+!hold_up : not awaits_others               <- !wait.
+!hold_up : comes_in(S) & S < 5 & avoids(0) <- !to(toe); !hold_up.
+!hold_up                                   <- !wait; !hold_up.

+!split <- !wait_for_the_brink; !get(out).

+!stay_behind <- !wait; !stay_behind.
