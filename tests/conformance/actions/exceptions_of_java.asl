// Where an action of Jason ends in an exception of Java, the error is unknown and has no message. Actions
// that do not count their arguments pass over those that are too many.
!start.
+!start <- for (.range(I, 1, 40)) { !t(I) }.
-!t(I)[error(E), error_msg(M)] <- .print(I, " ", E, " (", M, ")").
+!t(1) <- .printf(3).
+!t(2) <- .printf.
+!t(3) <- .asserta(3).
+!t(4) <- .assertz("text").
+!t(5) <- .map.copy(a, a).
+!t(6) <- .set.create.
+!t(7) <- .set.create(S, [], more, still); .print("7 ", S).
+!t(8) <- .set.add([1, 2], a).
+!t(9) <- .set.add(S, a, b); .print("9 ", S).
+!t(10) <- .set.add_all(_, a).
+!t(11) <- .queue.head(_, _).
+!t(12) <- .queue.create(Q); .queue.add_all(Q, a).
+!t(13) <- .replace("abc", b, "x", _).
+!t(14) <- .replace("abc", "b", x, _).
+!t(15) <- .replace(abc, "b", "x", R); .print("15 ", R).
+!t(16) <- .replace("abc", "(", "x", _).
+!t(17) <- .log(1.5, a).
+!t(18) <- .log([a], "as info").
+!t(19) <- .belief(3).
+!t(20) <- .belief.
+!t(21) <- .concat.
+!t(22) <- .set_random_seed(a).
+!t(23) <- .set_random_seed.
+!t(24) <- .namespace_set_prop(ns, 3, v).
+!t(25) <- .namespace_get_prop(ns, 3, _).
+!t(26) <- .add_plan("(").
+!t(27) <- .add_plan(~a).
+!t(28) <- .add_plan([a]).
+!t(29) <- .remove_plan(3).
+!t(30) <- .remove_plan("l").
+!t(31) <- .remove_plan({ +!g }).
+!t(32) <- .plan_label(3, _).
+!t(33) <- .wait(a, "long").
+!t(34) <- .wait("no trigger").
+!t(35) <- .at(1, { +!g }).
+!t(36) <- .signal(3).
+!t(37) <- .findall(X, "p(X)", _).
+!t(38) <- .eval(_, 3).
+!t(39) <- .max(X, "p(X)", _).
+!t(40) <- .suspended(3, _).
// expect: 1 unknown ()
// expect: 2 unknown ()
// expect: 3 unknown ()
// expect: 4 unknown ()
// expect: 5 unknown ()
// expect: 6 unknown ()
// expect: 7 {}
// expect: 8 unknown ()
// expect: 9 {a}
// expect: 10 unknown ()
// expect: 11 unknown ()
// expect: 12 unknown ()
// expect: 13 unknown ()
// expect: 14 unknown ()
// expect: 15 axc
// expect: 16 unknown ()
// expect: 17 unknown ()
// expect: as info
// expect: 19 unknown ()
// expect: 20 unknown ()
// expect: 21 unknown ()
// expect: 22 unknown ()
// expect: 23 unknown ()
// expect: 24 unknown ()
// expect: 25 unknown ()
// expect: 26 unknown ()
// expect: 27 wrong_arguments (Wrong argument for internal action 'add_plan': The term '~a' (LiteralImpl) can not be used as a plan for .add_plan.)
// expect: 28 wrong_arguments (Wrong argument for internal action 'add_plan': The term 'a' (Atom) can not be used as a plan for .add_plan.)
// expect: 29 unknown ()
// expect: 30 unknown ()
// expect: 31 unknown ()
// expect: 32 unknown ()
// expect: 33 unknown ()
// expect: 34 unknown ()
// expect: 35 unknown ()
// expect: 36 unknown ()
// expect: 37 wrong_arguments (Wrong argument for internal action 'findall': second argument must be a formula)
// expect: 38 wrong_arguments (Wrong argument for internal action 'eval': second argument must be a logical formula)
// expect: 39 unknown ()
// expect: 40 wrong_arguments (Wrong argument for internal action 'suspended': first argument must be a literal)
