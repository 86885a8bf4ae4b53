// A context `true` is none.
!start.
@l +!g : true <- +done.
+!start <- .plan_label(P, l); Q = { @l[source(self)] +!g <- +done };
           if (P == Q) { .print("the same plan") } else { .print(P, " is not ", Q) }.
// expect: the same plan
