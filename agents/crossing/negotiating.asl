// Negotiating: as proximity, but pedestrians do not walk through each other. In every tick each tells
// all others where it stands and where it wants to step; it steps unless another stands there, or one
// with a lower number wants to go there, too.

{ include("shared/steps.asl") }
{ include("shared/nearness.asl") }

!exercise_av.

+!exercise_av : first_way(either) <- .random([forward, back], Way); +way(Way); !go.
+!exercise_av : first_way(Way)    <- +way(Way); !go.

// Where the next step would lead: across once the AV has come near, else along the pavement.
next(left, X - V, Y)    :- at(X, Y) & walking_speed(V).
next(right, X + V, Y)   :- at(X, Y) & walking_speed(V).
next(forward, X, Y + V) :- at(X, Y) & walking_speed(V).
next(back, X, Y - V)    :- at(X, Y) & walking_speed(V).
turned(forward, back).
turned(back, forward).

+!go : crossing(Way) & across(Way, Step)             <- !claim(Step).
+!go : crossing(_)                                   <- !claim(none).
+!go : distance_to_av(D) & near(D) & way_across(Way) <- +crossing(Way); !go.
+!go : way(Way) & free(Way)                          <- !claim(Way).
+!go : way(Way) & turned(Way, Other)                 <- -+way(Other); !claim(Other).

+!claim(none) : at(X, Y)        <- !tell(none, X, Y).
+!claim(Way)  : next(Way, X, Y) <- !tell(Way, X, Y).
+!tell(Way, ToX, ToY) : tick(T) & id(Me) & at(X, Y)
  <- -+wish(Way);
     .broadcast(tell, claim(T, Me, X, Y, ToX, ToY));
     +claim(T, Me, X, Y, ToX, ToY).

+claim(T, _, _, _, _, _) : pedestrians(N) & .count(claim(T, _, _, _, _, _), N) <- !decide(T).

// A step from (X,Y) to (ToX,ToY) would make the body touch, and come nearer to, one at (OtherX,OtherY).
size(0.5).  // of a body, in metres
touches(X, Y, ToX, ToY, OtherX, OtherY) :-
  size(M) & cell_length(Cell) & math.abs(ToX - OtherX) < M / Cell &
  math.abs(ToY - OtherY) < M / Cell &
  math.abs(ToX - OtherX) + math.abs(ToY - OtherY) < math.abs(X - OtherX) + math.abs(Y - OtherY).

taken(T) :-
  id(Me) & claim(T, Me, X, Y, ToX, ToY) & claim(T, Other, OtherX, OtherY, _, _) & Other \== Me &
  touches(X, Y, ToX, ToY, OtherX, OtherY).
taken(T) :-
  id(Me) & claim(T, Me, X, Y, ToX, ToY) & claim(T, Other, _, _, OtherX, OtherY) & Other < Me &
  touches(X, Y, ToX, ToY, OtherX, OtherY).

+!decide(T) : wish(none) | taken(T) <- .abolish(claim(T, _, _, _, _, _)); stay; !go.
+!decide(T) : wish(Way)             <- .abolish(claim(T, _, _, _, _, _)); move(Way); !go.
