// Orders beer, drinks what he gets, orders the next one; goes to bed when the robot refuses.

!order.

+!order <- .send(robot, achieve, serve(beer)).

+has(owner, beer) <- !drink; !order.

+!drink : has(owner, beer) <- sip(beer); !drink.
+!drink.

+enough_for_today(Glasses)[source(robot)]
  <- .print("After ", Glasses, " beers it is time to go to bed.").
