// A small auction: rules, messages, annotations, loops.
item(vase, 10)[rare]. item(lamp, 3).
budget(20).
can_pay(I) :- item(I, P) & budget(B) & P <= B & not sold(I, _).
best(I, V) :- .findall(b(V2, A), bid(I, V2)[source(A)], L) & .max(L, b(V, _)).

!open.

+!open : can_pay(I) <-
  .print("open ", I);
  .broadcast(tell, auction(I));
  .wait(10);
  if (best(I, V)) { +sold(I, V); } else { .print("no bid") };
  !open.
+!open <- for (sold(I, V)) { .print(I, " for ", V) }.
-!open[error(E), code(C)] <- .print("failed: ", E, " ", C).

@react[atomic] +auction(I)[source(S)] : S \== self <- ?item(I, P); .send(S, tell, bid(I, P + 1)).
+bid(_, V)[source(S)] : V < 0 <- .send(S, untell, auction(vase)).
