// Serves beer up to a limit, and orders more when the fridge is empty.

limit(10).
served(0).

+!serve(beer)[source(Guest)] : limit(Most) & served(Most)
  <- .send(Guest, tell, enough_for_today(Most)).
+!serve(beer) : served(Before)
  <- !reach(fridge);
     open(fridge);
     !take_beer;
     close(fridge);
     !reach(owner);
     hand_in(beer);
     -+served(Before + 1).

// The stock is seen while the fridge is open.
+!take_beer : stock(beer, 0)
  <- .print("The fridge is empty.");
     .send(supermarket, achieve, order(beer, 5));
     .wait(stock(beer, Some) & Some > 0);
     !take_beer.
+!take_beer <- get(beer).

+!reach(Place) : at(robot, Place).
+!reach(Place) <- move_towards(Place); !reach(Place).
