// What each test of types does ordinarily, at the boundary, and when it fails.
!start.
+!start
  <- for (.member(A, [".atom", ".ground", ".list", ".literal", ".number", ".string", ".structure", ".internal_action", ".type"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".atom") <- .atom(a); .print("an atom").
+!boundary(".atom") <- if (not .atom(~a) & not .atom(a[k]) & .atom('A b') & not .atom(_)) { .print("without anything") }.
+!failure(".atom") <- .atom(f(1)).
+!ordinary(".ground") <- .ground(f(a, [1])); .print("ground").
+!boundary(".ground") <- if (not .ground(a[k(_)]) & .ground([]) & not .ground([a|_])) { .print("annotations count") }.
+!failure(".ground") <- .ground(f(_)).
+!ordinary(".list") <- .list([a]); .print("a list").
+!boundary(".list") <- if (.list([]) & .list([_|_]) & not .list("[]") & not .list(_)) { .print("also the empty one") }.
+!failure(".list") <- .list(a).
+!ordinary(".literal") <- .literal(f(a)); .print("a literal").
+!boundary(".literal") <- if (.literal(~a) & .literal(a[k]) & not .literal([]) & not .literal(_)) { .print("no lists") }.
+!failure(".literal") <- .literal(3).
+!ordinary(".number") <- .number(3); .print("a number").
+!boundary(".number") <- if (.number(-0.5) & .number(1 + 2) & not .number("3") & not .number(_)) { .print("also a sum") }.
+!failure(".number") <- .number("3").
+!ordinary(".string") <- .string("a"); .print("a string").
+!boundary(".string") <- if (.string("") & not .string('a') & not .string(_)) { .print("also the empty one") }.
+!failure(".string") <- .string(a).
+!ordinary(".structure") <- .structure(f(a)); .print("a structure").
+!boundary(".structure") <- if (.structure([]) & .structure(a[k]) & .structure(~a) & not .structure(_)) { .print("also lists") }.
+!failure(".structure") <- .structure("f(a)").
+!ordinary(".internal_action") <- .internal_action(.print(1)); .print("one").
+!boundary(".internal_action") <- if (not .internal_action(print) & not .internal_action("print")) { .print("with a point") }.
+!failure(".internal_action") <- .internal_action(print(1)).
+!ordinary(".type") <- .findall(T, .type(f(1), T), L); .print(L).
+!boundary(".type") <- .findall(T, .type(_, T), L); .findall(T, .type({ +!g <- a }, T), M); .print(L, M).
+!failure(".type") <- .type(a, number).
// expect: an atom
// expect: without anything
// expect: .atom ia_failed
// expect: ground
// expect: annotations count
// expect: .ground ia_failed
// expect: a list
// expect: also the empty one
// expect: .list ia_failed
// expect: a literal
// expect: no lists
// expect: .literal ia_failed
// expect: a number
// expect: also a sum
// expect: .number ia_failed
// expect: a string
// expect: also the empty one
// expect: .string ia_failed
// expect: a structure
// expect: also lists
// expect: .structure ia_failed
// expect: one
// expect: with a point
// expect: .internal_action ia_failed
// expect: [literal,structure,ground]
// expect: [free][literal,structure,ground]
// expect: .type ia_failed
