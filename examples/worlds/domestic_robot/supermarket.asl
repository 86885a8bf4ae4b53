// Brings what is ordered: a delivery takes a while, during which the others go on.

+!order(What, Number)[source(Customer)]
  <- deliver(What, Number);
     .print("delivered ", Number, " of ", What, " to ", Customer).
