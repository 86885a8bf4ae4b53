// What each action that writes does ordinarily, at the boundary, and when it fails; most never do.
!start.
+!start
  <- for (.member(A, [".print", ".println", ".printf", ".puts", ".log", ".verbose", ".print_unifier"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".print") <- .print("a", b, 1, [c, "d"], f("e")).
+!boundary(".print") <- .print; .print(""); .print(X, [X]); .print(2.0, " ", 1.0E20, " ", -0.5).
+!failure(".print") <- if (.print("never") & false) { .print("bad") } else { .print("fails") }.
+!ordinary(".println") <- .println("a", b, 1, [c, "d"]).
+!boundary(".println") <- .println; .println(X).
+!failure(".println") <- if (not .println("never fails")) { .print("bad") }.
+!ordinary(".printf") <- .printf("%s is %.1f", a, 2).
+!boundary(".printf") <- .printf("%%"); .printf("%5.2f|%-3s|%s", 3.14159, b, "c"); .printf("one %s", 1, unused).
+!failure(".printf") <- .printf("%d", 1).
+!ordinary(".puts") <- X = 1; .puts("X is #{X}").
+!boundary(".puts") <- .puts(""); .puts("#{Free}"); X = f("a"); .puts("#{X}#{X}", R); .print(R).
+!failure(".puts") <- .puts.
+!ordinary(".log") <- .log(info, "a ", 1); .log(warning, "in the log").
+!boundary(".log") <- .log(info); .log(fine, "dropped"); .log(loudly, "as info").
+!failure(".log") <- .log("info", text).
+!ordinary(".verbose") <- .verbose(2); .log(fine, "shown"); .verbose(1); .log(fine, "dropped").
+!boundary(".verbose") <- .verbose(1); .print("as before").
+!failure(".verbose") <- .verbose(much).
+!ordinary(".print_unifier") <- X = 1; .print_unifier.
+!boundary(".print_unifier") <- .print_unifier.
+!failure(".print_unifier") <- if (not .print_unifier) { .print("bad") }.
// expect log: in the log
// expect: ab1[c,"d"]f("e")
// expect:
// expect:
// expect: X<no-value>[X]
// expect: 2 1.0E20 -0.5
// expect: never
// expect: fails
// expect: ab1[c,"d"]
// expect:
// expect: X<no-value>
// expect: never fails
// expect: a is 2.0
// expect: %
// expect:  3.14|b  |c
// expect: one 1.0
// expect: .printf unknown
// expect: X is 1
// expect:
// expect: Free
// expect: f("a")f("a")
// expect: .puts wrong_arguments
// expect: a 1
// expect:
// expect: as info
// expect: .log unknown
// expect: shown
// expect: as before
// expect: .verbose unknown
// expect: X=1
// expect: done
// expect: done
// expect: done
