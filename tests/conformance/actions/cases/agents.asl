// What each action on agents and messages does ordinarily, at the boundary, and when it fails.
// agent ann
price(3).
!start.
+!start
  <- for (.member(A, [".my_name", ".all_names", ".send", ".broadcast", ".kqml_answer", ".df_register", ".df_search",
                      ".df_subscribe", ".df_deregister", ".create_agent", ".clone", ".kill_agent"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).
+text(X)[source(S)] <- .print(X, " from ", S).
+provider(A, S) <- .print(A, " offers ", S).

+!ordinary(".my_name") <- .my_name(N); .print(N).
+!boundary(".my_name") <- .my_name(ann); .print("ann").
+!failure(".my_name") <- .my_name(bob).
+!ordinary(".all_names") <- .all_names(L); .sort(L, S); .print(S).
+!boundary(".all_names") <- .all_names([_|T]); .length(T, N); .print(N).
+!failure(".all_names") <- .all_names([]).
+!ordinary(".send") <- .send(bob, tell, text(1)); .send(bob, askOne, price(_), price(P)); .print(P).
+!boundary(".send") <- .send(ann, tell, text(2)); .send([], tell, text(3)); .send("bob", tell, text(4)); .send(bob, askOne, none, A); .print(A); .wait(20).
+!failure(".send") <- .send(nobody, tell, text(5)).
+!ordinary(".broadcast") <- .broadcast(tell, text(6)); .wait(20).
+!boundary(".broadcast") <- .broadcast(achieve, say([])); .wait(20).
+!failure(".broadcast") <- .broadcast(tell).
+!ordinary(".kqml_answer") <- .findall(A, .kqml_answer(price(_), A), L); .print(L).
+!boundary(".kqml_answer") <- .kqml_answer(price(3), A); .print(A).
+!failure(".kqml_answer") <- .kqml_answer(none, _).
+!ordinary(".df_register") <- .df_register("sing"); .df_search("sing", L); .print(L).
+!boundary(".df_register") <- .df_register("sing"); .df_register("swim", sport); .df_search("sing", L); .df_search("swim", sport, M); .print(L, M).
+!failure(".df_register") <- .df_register.
+!ordinary(".df_search") <- .df_search("sing", L); .print(L).
+!boundary(".df_search") <- .df_search("fly", L); .print(L).
+!failure(".df_search") <- .df_search("sing", [bob]).
+!ordinary(".df_subscribe") <- .df_subscribe("dance"); .send(bob, achieve, dance); .wait(50).
+!boundary(".df_subscribe") <- .df_subscribe("fly"); .df_register("fly"); .wait(50).
+!failure(".df_subscribe") <- .df_subscribe.
+!ordinary(".df_deregister") <- .df_deregister("sing"); .df_search("sing", L); .print(L).
+!boundary(".df_deregister") <- .df_deregister("none"); .print("none").
+!failure(".df_deregister") <- .df_deregister.
+!ordinary(".create_agent") <- .create_agent(cid, "cid.asl"); .wait(20).
+!boundary(".create_agent") <- .create_agent(cid); .create_agent(Dan); .print(Dan); .all_names(L); .length(L, N); .print(N).
+!failure(".create_agent") <- .create_agent(eve, "missing.asl").
+!ordinary(".clone") <- .clone(twin); .send(twin, askOne, price(_), price(P)); .print(P).
+!boundary(".clone") <- .clone(twin); .all_names(L); .length(L, N); .print(N).
+!failure(".clone") <- .clone.
+!ordinary(".kill_agent") <- .kill_agent(cid); .wait(20); .all_names(L); .length(L, N); .print(N).
+!boundary(".kill_agent") <- .kill_agent("dan", 30); .wait(100); .all_names(L); .length(L, N); .print(N).
+!failure(".kill_agent") <- .kill_agent(nobody).
// agent bob
price(5).
+text(X)[source(S)] <- .print(X, " from ", S).
+!say(X)[source(S)] <- .print(X, " from ", S).
+!dance <- .df_register("dance").
// expect [ann]: ann
// expect [ann]: ann
// expect [ann]: .my_name ia_failed
// expect [ann]: [ann,bob]
// expect [ann]: 1
// expect [ann]: .all_names ia_failed
// expect [ann]: 5
// expect [ann]: 2 from self
// expect [ann]: false
// expect [ann]: .send receiver_not_found
// expect [ann]: .broadcast wrong_arguments
// expect [ann]: [price(3)]
// expect [ann]: price(3)
// expect [ann]: .kqml_answer ia_failed
// expect [ann]: [ann]
// expect [ann]: [ann][ann]
// expect [ann]: .df_register wrong_arguments
// expect [ann]: [ann]
// expect [ann]: []
// expect [ann]: .df_search ia_failed
// expect [ann]: bob offers dance
// expect [ann]: ann offers fly
// expect [ann]: .df_subscribe wrong_arguments
// expect [ann]: []
// expect [ann]: none
// expect [ann]: .df_deregister wrong_arguments
// expect [ann]: dan
// expect [ann]: 5
// expect [ann]: .create_agent internal_action
// expect [ann]: 3
// expect [ann]: 7
// expect [ann]: .clone wrong_arguments
// expect [ann]: 6
// expect [ann]: 5
// expect [ann]: .kill_agent ia_failed
// expect [bob]: 1 from ann
// expect [bob]: 4 from ann
// expect [bob]: 6 from ann
// expect [bob]: [] from ann
// expect [cid]: works
// file cid.asl
!work.
+!work <- .print("works").
