// `[|T]` takes the remaining annotations, but stays open if the others suffice to find the belief.
p(a)[source(ann), u, t(1)].
q(a)[u].
r(a)[u, t(2)].
!start.
+!start
  <- -p(a)[source(S)|T]; .print(S, T); .count(p(_), N); .print(N);
     -q(a)[source(self)|R]; if (.ground(R)) { .print(R) } else { .print(open) }; .count(q(_), M); .print(M);
     -r(_)[|W]; .print(W).
-r(X)[|L] <- .print("not ", X, L).
// expect: ann[t(1),u]
// expect: 0
// expect: open
// expect: 0
// expect: not a[source(self),t(2),u]
// expect: [t(2),u]
