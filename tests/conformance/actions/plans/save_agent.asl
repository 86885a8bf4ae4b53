// .save_agent writes a program that is the same agent: beliefs with their order, annotations and
// texts, rules, functions, plans with labels, conditions and sub-plans; and the goals that are given.
// expect: saved
// expect [copy]: [3,1,2]
// expect [copy]: [source(self),told]
// expect [copy]: a "quoted" text
// expect [copy]: 2 12
// expect [copy]: sub-plan for 5
// expect [copy]: many
// expect [copy]: atomic1
// expect [copy]: failed
n(1). n(2)[told].
says("a \"quoted\" text").
big(X) :- n(X) & (X > 1 | X == 7) & not X > 2.
{ register_function("my.next",1,"next") }
next(X,X+10).
!go.
+!go <- +n(3); .save_agent("copy.asl",[start]); .print(saved); .create_agent(copy,"copy.asl").
+!start <- .findall(X,n(X),L); .print(L); ?n(2)[|A]; .print(A); ?says(S); .print(S);
           ?big(B); .print(B," ",my.next(B)); !outer(5); !loop; !label; !fails.
+!outer(X) <: false <- !inner; .done. {
  +!inner <- .print("sub-plan for ",X).
}
+!loop <- for (n(X)) { if (X > 2) { .print(many) } }.
@here[atomic,cost(1)] +!label <- .plan_label({@L[|As] +!label <- _},here); .member(atomic,As);
                                 .print(atomic,1).
-!label <- .print(atomic,1).
+!fails : n(1)[source(self)] <- .fail.
-!fails[error(E)] <- .print(failed).
