// What error_msg says when an action is called wrongly: Jason's own words.
!start.
+!start <- for (.range(I, 1, 31)) { !t(I) }.
-!t(I)[error(E), error_msg(M)] <- .print(I, " ", E, ": ", M).
+!t(1) <- .nth(5, [a], _).
+!t(2) <- .nth(a, [a], _).
+!t(3) <- .nth(0, a, _).
+!t(4) <- .nth(0, [a]).
+!t(5) <- .my_name.
+!t(6) <- .range(_, 1).
+!t(7) <- .range(_, 1, a).
+!t(8) <- .reverse([a], x).
+!t(9) <- .reverse(ab, ba).
+!t(10) <- .concat([a], [b], x).
+!t(11) <- .concat([a], b, _).
+!t(12) <- .union([a], b, _).
+!t(13) <- .difference([a], [b], x).
+!t(14) <- .max(a, _).
+!t(15) <- .sort(a, _).
+!t(16) <- .set.add(S, a); .sort(S, _).
+!t(17) <- .member(a, b).
+!t(18) <- .prefix(a, "abc").
+!t(19) <- .suffix(_, a).
+!t(20) <- .sublist(_, "abc").
+!t(21) <- .term2string(a, b).
+!t(22) <- .delete(a, b, _).
+!t(23) <- .at("soon", {+!g}).
+!t(24) <- .at("now", {+!g}).
+!t(25) <- .random([a], b).
+!t(26) <- .relevant_plans(1, _).
+!t(27) <- .suspend(1).
+!t(28) <- .drop_intention(1).
+!t(29) <- .intend("g").
+!t(30) <- .send(1, tell, x).
+!t(31) <- .send([1], tell, x).
// expect: 1 internal_action: nth: index 5 is out of bounds (1)
// expect: 2 wrong_arguments: Wrong argument for internal action 'nth': the first argument should be numeric or a variable -- not 'a'.
// expect: 3 wrong_arguments: Wrong argument for internal action 'nth': the second argument should be a list or string and not 'a'.
// expect: 4 wrong_arguments: The internal action 'nth' has not received the required number of argument(s). 3 arguments are expected.
// expect: 5 wrong_arguments: The internal action 'my_name' has not received the required number of argument(s). One argument is expected.
// expect: 6 wrong_arguments: The internal action 'range' has not received the required number of argument(s). From 3 to 4 arguments are expected.
// expect: 7 wrong_arguments: Wrong argument for internal action 'range': third parameter ('a') must be a number!
// expect: 8 wrong_arguments: Wrong argument for internal action 'reverse': last argument 'x' must be a list or a variable.
// expect: 9 wrong_arguments: Wrong argument for internal action 'reverse': last argument 'ba' must be a string or a variable.
// expect: 10 internal_action: Last argument of concat 'x'is not a list nor a variable.
// expect: 11 wrong_arguments: Wrong argument for internal action 'concat': arg[1] is not a list
// expect: 12 wrong_arguments: Wrong argument for internal action 'union': second argument 'b'is not a list.
// expect: 13 wrong_arguments: Wrong argument for internal action 'difference': last argument 'x'is not a list nor a variable.
// expect: 14 wrong_arguments: Wrong argument for internal action 'max': first argument must be a list when two arguments are used
// expect: 15 wrong_arguments: Wrong argument for internal action 'sort': first argument must be a list
// expect: 16 wrong_arguments: Wrong argument for internal action 'sort': first argument must be a list
// expect: 17 wrong_arguments: Wrong argument for internal action 'member': second argument must be a list or a set
// expect: 18 wrong_arguments: Wrong argument for internal action 'prefix': first argument must be a list, string, or a variable
// expect: 19 wrong_arguments: Wrong argument for internal action 'suffix': second argument must be either a list or a string
// expect: 20 wrong_arguments: Wrong argument for internal action 'sublist': second argument must be a list
// expect: 21 internal_action: invalid case of term2string
// expect: 22 internal_action: Incorrect use of the internal action '.delete' (see documentation).
// expect: 23 internal_action: The time parameter ('soon') of the internal action 'at' is not implemented!
// expect: 24 internal_action: The time parameter ('"now"') of the internal action 'at' did not parse correctly!
// expect: 25 wrong_arguments: Wrong argument for internal action 'random': second argument must be a variable.
// expect: 26 wrong_arguments: Wrong argument for internal action 'relevant_plans': first argument '1' must follow the syntax of a trigger.
// expect: 27 wrong_arguments: Wrong argument for internal action 'suspend': first argument must be a literal
// expect: 28 wrong_arguments: Wrong argument for internal action 'drop_intention': first argument '1' must be a literal or variable
// expect: 29 wrong_arguments: Wrong argument for internal action 'intend': first argument must be a literal or variable
// expect: 30 wrong_arguments: Wrong argument for internal action 'send': TO parameter ('1') must be an atom, a string or a list of receivers!
// expect: 31 internal_action: The TO parameter ('1') of the internal action 'send' is not an atom!
