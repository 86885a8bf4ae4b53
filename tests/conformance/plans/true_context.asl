// A context `true` is none, and none is seen as `true`.
!start.
@l +!g : true <- +done.
+!start <- .plan_label(P, l); Q = { @l[source(self),url("file:agent.asl")] +!g <- +done };
           if (P == Q) { .print("the same plan") } else { .print(P, " is not ", Q) };
           P = { @_ +!_ : Context <- _ }; .print(Context).
// expect: the same plan
// expect: true
