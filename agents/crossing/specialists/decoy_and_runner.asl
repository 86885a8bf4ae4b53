// Decoy and runner: the pedestrian nearest to the AV at the beginning stands short of the next one and
// makes the AV brake by a foot in the lane, then steps back; then it tells the others, who step out at
// the last moment. A pedestrian that is alone is both.

{ include("../shared/stepping.asl") }
{ include("../shared/company.asl") }

short_of(4).  // m before the runner, where the decoy stands

!exercise_av.

+!exercise_av <- !tell_where_i_stand; !set_out_across; !begin.

+!begin : decoy & runner(Y) & short_of(M) <- !along_to(Y - M); !get(beside); !draw; !stand_by.
+!begin : pedestrians(1)                  <- !get(beside); !draw; !run.
+!begin                                   <- !get(beside); !run.

decoy :- id(Me) & .findall(p(Y, Id), stood(Id, _, Y), All) & .min(All, p(_, Me)).
runner(Y) :- id(Me) & .findall(Y1, stood(Id, _, Y1) & Id \== Me, Others) & .min(Others, Y).

+!draw
  <- !wait_for_the_av(3.6);
     !get(toe);
     !wait_until_it_slows;
     !get(beside);
     .broadcast(tell, drawn).
+!wait_until_it_slows : slows | gone | about_to_pass.
+!wait_until_it_slows <- !wait; !wait_until_it_slows.

+!run <- !wait_for_the_brink; !get(middle); !stand.
+!stand : not gone & not stands <- !wait; !stand.
+!stand <- !get(out).
+!stand_by <- !wait; !stand_by.
