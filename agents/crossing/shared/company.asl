// Groups of pedestrians: in the first tick each tells the others where it stands.
// jaywalk: asks av_seen/3, side/1, y/1, !along_to/1, !get/1, !wait/0, !watch/0

+!tell_where_i_stand : id(Me) & side(Side) & y(Y)
  <- .broadcast(tell, stood(Me, Side, Y));
     +stood(Me, Side, Y);
     !watch;
     ?av_seen(F, _, _);
     +av_start(F);
     !wait.

// The post is the pedestrian that those of its side with higher numbers join: the first one that is
// far enough ahead of the AV to hold it up.
post(Id) :-
  id(Me) & stood(Me, Side, _) & .findall(P, stood(P, Side, Y) & far_ahead(Y), All) & .min(All, Id) &
  stood(Other, Side, _) & Other > Id.
joins(Id) :-
  post(Post) & stood(Post, Side, Y) & stood(Id, Side, Mine) & Id > Post & near_enough(Y, Mine).

far_ahead(Y)          :- av_start(F) & Y - F > 45.
near_enough(Y, Other) :- math.abs(Y - Other) < 25.

+!join : post(Post) & stood(Post, _, Y) & id(Me) <- !along_to(Y + 0.3 * (Me - Post)); !get(beside).

// A pedestrian that has arrived reports to the post, which waits for all that join it.
+!tell_the_post : id(Me) & post(Post) <- .concat("p", Post, Name); .send(Name, tell, here(Me)).
awaits_others :- id(Me) & post(Me) & not all_here.
all_here :- .count(joins(_), N) & .count(here(_), N).
