// A variable for a formula matches any, with its operator; the last one is the rest.
!start.
+!start <- B = {!a; +b; ?c};
           B = {First; Rest}; .print(First, " then ", Rest);
           {!Goal; _} = B; .print(Goal);
           {F; R} = {x}; .print(F, " then ", R);
           {One} = {!a}; .print(One);
           {S; .print(S)} = {!go; .print({!go})}; .print("bound twice").
-!start <- .print("a variable is one formula").
// expect: !a then { +b; ?c }
// expect: a
// expect: x then { }
// expect: { !a }
// expect: bound twice
