// Bodies as patterns: a variable stands for one formula with its operator, the last for the rest; a
// variable with an operator for a formula that has it.
// expect: !a | { ?b; .print(c) }
// expect: { !a }
// expect: !a | { }
// expect: goal a
// expect: no
// expect: executed a
// expect: executed b
!start.
+!start <- { F; R } = { !a; ?b; .print(c) }; .print(F," | ",R);
           { W } = { !a }; .print(W);
           { F1; R1 } = { !a }; .print(F1," | ",R1);
           { !G; _ } = { !a; !c }; .print("goal ",G);
           if (not { ?_; _ } = { !a; !c }) { .print(no) };
           { First; Rest } = { !x(a); !x(b) }; First; Rest.
+!x(X) <- .print("executed ",X).
