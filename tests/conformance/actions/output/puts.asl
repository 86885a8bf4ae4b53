// .puts fills in variables, or unifies the text with a variable; an unbound variable keeps its name.
!start.
+!start <- X = 2; .puts("v #{X}"); .puts("a#{X}b#{X}", R); .print(R); .puts("free #{Z}"); .puts("none").
// expect: v 2
// expect: a2b2
// expect: free Z
// expect: none
