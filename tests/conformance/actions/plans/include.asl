// .include adds a file's beliefs, goals and plans while the agent runs; in a namespace if one is
// given, in a new one if it is open. A file that is not there is told of, and the plan goes on.
// expect: initial goal of the file
// expect: red
// expect: initial goal of the file
// expect: red in m
// expect: initial goal of the file
// expect: red in ns1
// expect: 2 plans for hello
// expect: goes on
// expect log: missing.asl: no such file
!go.
+!go <- .include("colours.asl"); !hello(X); .print(X);
        .include("colours.asl",m); !m::hello(Y); .print(Y," in m");
        .include("colours.asl",N); !N::hello(Z); .print(Z," in ",N);
        .relevant_plans({+!hello(_)},L1); .relevant_plans({+!m::hello(_)},L2);
        .concat(L1,L2,L); .length(L,C); .print(C," plans for hello");
        .include("missing.asl"); .print("goes on").

// file colours.asl
colour(red).
!init.
+!init <- .print("initial goal of the file").
+!hello(X) : colour(X).
