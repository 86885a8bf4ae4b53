// Walks along the pavement and starts to cross the road at a given tick: a pedestrian without a will
// of its own, for whom a search decides.

{ include("shared/steps.asl") }

cross_at(5).  // tick

!stroll.

+!stroll : tick(T) & cross_at(Start) & T >= Start <- !cross_road.
+!stroll : not way(_) <- !set_out; !stroll.
+!stroll <- !walk; !stroll.
