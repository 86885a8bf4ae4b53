// .df_register, .df_deregister, .df_search, .df_subscribe; types of services tell nothing apart.
// agent ann
!start.
+!start
  <- .df_subscribe("sing"); .df_search("sing", L0); .print(L0); .df_register("sing"); .wait(100); .df_search("sing", L); .sort(L, S); .print(S);
     .df_search("sing", typed, T); .print(T); .df_deregister("sing"); .wait(50); .df_search("sing", M); .print(M).
+provider(A, S) : A == bob <- .print(A, " ", S).
// agent bob
!start.
+!start <- .wait(50); .df_register("sing"); .df_register("dance", typed).
// expect [ann]: []
// expect [ann]: bob sing
// expect [ann]: [ann,bob]
// expect [ann]: [ann,bob]
// expect [ann]: [bob]
