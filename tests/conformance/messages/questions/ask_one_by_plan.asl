// A plan +? may answer a question.
// agent ann
!start.
+!start <- .send(bob, askOne, price(_), price(P)); .print(P).
// agent bob
+?price(X) <- .print("asked"); X = 7.
// expect [ann]: 7
// expect [bob]: asked
