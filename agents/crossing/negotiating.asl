// Negotiating: as proximity, but nobody walks through anybody. In every tick each pedestrian tells all
// others where it stands and where it wants to step; it steps unless somebody stands there, or one of
// a lower number wants to go there, too.

{ include("shared/steps.asl") }
{ include("shared/nearness.asl") }

!exercise_av.

+!exercise_av : first_way(either) <- .random([forward, back], Way); +way(Way); !go.
+!exercise_av : first_way(Way)    <- +way(Way); !go.

// Where the next step would lead: across once the AV has come near, else along the pavement.
next(left, X - 1, Y)    :- at(X, Y).
next(right, X + 1, Y)   :- at(X, Y).
next(forward, X, Y + 1) :- at(X, Y).
next(back, X, Y - 1)    :- at(X, Y).
turned(forward, back).
turned(back, forward).

+!go : crossing(Way) & free(Way)                     <- !claim(Way).
+!go : crossing(_)                                   <- !claim(none).
+!go : distance_to_av(D) & near(D) & way_across(Way) <- +crossing(Way); !claim(Way).
+!go : way(Way) & free(Way)                          <- !claim(Way).
+!go : way(Way) & turned(Way, Other)                 <- -+way(Other); !claim(Other).

+!claim(none) : at(X, Y)        <- !tell(none, X, Y).
+!claim(Way)  : next(Way, X, Y) <- !tell(Way, X, Y).
+!tell(Way, ToX, ToY) : tick(T) & id(Me) & at(X, Y)
  <- -+wish(Way);
     .broadcast(tell, claim(T, Me, X, Y, ToX, ToY));
     +claim(T, Me, X, Y, ToX, ToY).

+claim(T, _, _, _, _, _) : pedestrians(N) & .count(claim(T, _, _, _, _, _), N) <- !decide(T).

taken(T) :- id(Me) & claim(T, Me, _, _, X, Y) & claim(T, Other, X, Y, _, _) & Other \== Me.
taken(T) :- id(Me) & claim(T, Me, _, _, X, Y) & claim(T, Other, _, _, X, Y) & Other < Me.

+!decide(T) : wish(none) | taken(T) <- .abolish(claim(T, _, _, _, _, _)); stay; !go.
+!decide(T) : wish(Way)             <- .abolish(claim(T, _, _, _, _, _)); move(Way); !go.
