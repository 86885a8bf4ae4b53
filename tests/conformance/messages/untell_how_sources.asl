// Plans that were told by several agents stay until all of them have taken them back (untellHow).
// agent lea
!start.
+!start <- .wait(300); .relevant_plans({ +!g }, _, L); .print(L); !g; .wait(400); .relevant_plans({ +!g }, _, M); .print(M); .wait(1000); .relevant_plans({ +!g }, _, N); .print(N).
// agent tom
!start.
+!start <- .send(lea, tellHow, { @how +!g <- .print(known) }); .wait(500); .send(lea, untellHow, how).
// agent sue
!start.
+!start <- .wait(100); .send(lea, tellHow, "@how +!g <- .print(known)."); .wait(1000); .send(lea, untellHow, how).
// expect [lea]: [how[source(sue),source(tom)]]
// expect [lea]: known
// expect [lea]: [how[source(sue)]]
// expect [lea]: []
