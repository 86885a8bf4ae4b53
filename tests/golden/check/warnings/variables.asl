// Variables that occur once, or have no value where one is needed.
price(tea, 2).
price(cake, 3).

!total.

+!total : not price(_, Dear) & Dear > 10
  <- .findall(P, price(_, P), Prices);
     .print(Prices, P + 1);
     for (price(What, Price)) { Sum = Price; .print(Sum * 2) };
     if (Sum > 3) { .print("more than three") };
     .print(Prcie).

+!quiet(X).  // jaywalk: allow singleton-variable, unused-plan
