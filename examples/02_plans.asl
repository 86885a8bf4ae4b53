// 2. Plans: the first plan whose condition holds is chosen, and a plan `-!` handles a failure.
//
//   jaywalk run examples/02_plans.asl

stock(tea, 1).
price(tea, 2).
price(milk, 3).
money(3).

!buy(tea).
!buy(milk).
!buy(salt).

+!buy(X) : stock(X, N) & N > 0 <- .print("there is ", X, " at home").
+!buy(X) : price(X, P) & money(M) & P <= M
  <- -+money(M - P);  // replaces the belief
     !carry(X);       // a goal of its own: first this, then the rest
     .print("bought ", X).
-!buy(X) <- .print("cannot buy ", X).

+!carry(X) <- .print("carrying ", X).

+money(0) <- .print("no money is left").  // a plan for a belief that is added
