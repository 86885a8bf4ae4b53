// A string is printed without its quotes, within a term with them; what it has is not escaped again.
!start.
+!start <- .print("a b"); .print(f("a b")); .print(["a", b]); .print(f("say \"no\"")).
// expect: a b
// expect: f("a b")
// expect: ["a",b]
// expect: f("say "no"")
