// Plan bodies are terms and print as they are executed.
!start.
+!start <- B = { .print(one); !two }; .print(B); B.
+!two <- .print("two").
// expect: { .print(one); !two }
// expect: one
// expect: two
