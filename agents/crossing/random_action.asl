// Random action: in every tick one of the steps that stay on the grid, or none, all equally likely.

{ include("shared/ways.asl") }

!wander.

+!wander <- .findall(move(Way), free(Way), Moves); .random([stay|Moves], Action); Action; !wander.
