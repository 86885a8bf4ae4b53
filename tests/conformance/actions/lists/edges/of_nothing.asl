// What actions on lists make of the empty list.
!start.
+!start
  <- .length([], N); .reverse([], R); .sort([], S); .union([], [a], U); .intersection([], [a], I); .difference([], [a], D);
     .print(N, R, S, U, I, D); .findall(P, .prefix(P, []), Ps); .findall(Q, .sublist(Q, []), Qs); .print(Ps, Qs); !max; !nth.
+!max <- .max([], _); .print("never").
-!max[error(E)] <- .print(E).
+!nth <- .nth(0, [], _); .print("never").
-!nth[error(E)] <- .print(E).
// expect: 0[][][a][][]
// expect: [[]][[]]
// expect: ia_failed
// expect: internal_action
