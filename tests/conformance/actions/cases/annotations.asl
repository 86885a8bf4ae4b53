// What each action on annotations and copies does ordinarily, at the boundary, and when it fails.
!start.
+!start
  <- for (.member(A, [".add_annot", ".add_nested_source", ".remove_source_annot", ".copy_term", ".rename_apart", ".get_src_info"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).

+!ordinary(".add_annot") <- .add_annot(a, k(1), R); .print(R).
+!boundary(".add_annot") <- .add_annot(a[k], k, R); .add_annot([], k, S); .add_annot([a, b[j]], k, T); .print(R, S, T).
+!failure(".add_annot") <- .add_annot(a, k, b[k]).
+!ordinary(".add_nested_source") <- .add_nested_source(a, bob, R); .print(R).
+!boundary(".add_nested_source") <- .add_nested_source(a[source(x), k], bob, R); .add_nested_source([], bob, S); .add_nested_source(3, bob, T); .print(R, S, T).
+!failure(".add_nested_source") <- .add_nested_source(a, bob, a[source(tom)]).
+!ordinary(".remove_source_annot") <- .remove_source_annot(a[source(bob), k], R); .print(R).
+!boundary(".remove_source_annot") <- .remove_source_annot(a, R); .remove_source_annot([], S); .remove_source_annot([a[source(x)]], T); .print(R, S, T).
+!failure(".remove_source_annot") <- .remove_source_annot(a[source(bob)], b).
+!ordinary(".copy_term") <- .copy_term(f(X, X, Y), f(A, B, C)); A = 1; .print(B, X).
+!boundary(".copy_term") <- .copy_term(a, R); .copy_term([], S); .copy_term("s", T); .copy_term(2, U); .print(R, S, T, U).
+!failure(".copy_term") <- .copy_term(f(1), f(2)).
+!ordinary(".rename_apart") <- .rename_apart(f(X, X, Y), f(A, B, C)); A = 1; .print(B, X).
+!boundary(".rename_apart") <- .rename_apart(a, R); .rename_apart(f(a), S); .print(R, S).
+!failure(".rename_apart") <- .rename_apart(f(1), f(2)).
+!ordinary(".get_src_info") <- .get_src_info(p, R); R =.. [_, F, _, [code_line(N), _]]; .print(F, N).
+!boundary(".get_src_info") <- .get_src_info(p(1)[k], R); R =.. [_, F, [X], [_, _, K]]; .print(F, X, K).
+!failure(".get_src_info") <- .get_src_info(p, q).
// expect: a[k(1)]
// expect: a[k][][a[k],b[j,k]]
// expect: .add_annot ia_failed
// expect: a[source(bob)]
// expect: a[k,source(bob)[source(x)]][]3
// expect: .add_nested_source ia_failed
// expect: a[k]
// expect: a[][a]
// expect: .remove_source_annot ia_failed
// expect: 1X<no-value>
// expect: a[]s2
// expect: .copy_term ia_failed
// expect: 1X<no-value>
// expect: af(a)
// expect: .rename_apart ia_failed
// expect: p24
// expect: p1k
// expect: .get_src_info ia_failed
