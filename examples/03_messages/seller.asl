// Announces the auction, waits until all three bids are there, and accepts the highest.

!sell(painting).

+!sell(Item)
  <- .broadcast(achieve, bid(Item));
     .wait(.count(offer(Item, _), 3));
     .findall(offered(Price, Who), offer(Item, Price)[source(Who)], Offers);
     .max(Offers, offered(Best, Winner));
     .print(Winner, " gets the ", Item, " for ", Best);
     .send(Winner, tell, sold(Item, Best)).
