// .list_rules prints the rules; without any it prints nothing.
p(X) :- q(X).
q(1).
!start.
+!start <- .list_rules; .print("done").
// expect: p(X)[source(self)] :- q(X)
// expect: done
