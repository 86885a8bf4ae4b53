// Rules select__option/4 choose among the options: one for each plan, or for each solution of its
// context with all_unifs. Where they select none, the goal fails with no_option.
// expect: two 1
// expect: all 3
// expect: internal goal
// expect: no_option
// expect: no_relevant
// expect: still there
select__option(_,_,{@two[|_] +!g : _ <- _},_).
select__option({+!h[|_]},-1,_,U) :- .member(map(_,3),U).
select__option({+!sub[|_]},I,_,_) :- I > 0.
select__option({+!E},_,_,_) :- not g = E & not h = E & not sub = E & not none = E.
select__option({-!_},_,_,_).
n(1). n(2). n(3).
!start.
+!start <- !g; !!h; .wait(10); !sub; !none.
-!start[error(E)] <- .print(E); !unknown.
-!unknown[error(E)] <- .print(E); !last.
+!last <- .print("still there").
@one +!g : n(X) <- .print("one ",X).
@two +!g : n(X) <- .print("two ",X).
@three[all_unifs] +!h : n(X) <- .print("all ",X).
+!sub <- .print("internal goal").
+!none <- .print("never").
