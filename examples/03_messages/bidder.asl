// Answers with what it can pay: bidder1 has 10, bidder2 20, bidder3 30.

+!bid(Item)[source(Seller)]
  <- .my_name(Me);
     .delete("bidder", Me, Number);
     .term2string(N, Number);
     .send(Seller, tell, offer(Item, N * 10)).

+sold(Item, Price) <- .print("I have the ", Item, ", it cost ", Price).
