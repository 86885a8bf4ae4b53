// What the failed body has bound is open again in the plan for the failure, whose values are
// returned: a default. What the head and the context have bound stays in the goal.
!start.
p(5).
+!start <- !c(X); .print(X); !d(Y); .print(Y); ?t(Z); .print(Z); !e(f(W)); .print(W);
   !p(Q); !is_open(Q); !n(N); .print(N); !last(3,L); .print(L); for (.range(I,1,2)) { !c(V); .print(I,V) };
   !deep(D); .print(D).
+!c(A) <- A = 1; .fail.
-!c(A) <- A = h.
+!d(A) <- !dd(A); .fail.
+!dd(2).
-!d(A) : not .ground(A) <- .print(open); A = hd.
+?t(A) <- A = 1; ?nothing(A).
-?t(A) <- A = ht.
+!e(A) <- A = f(1); .fail.
-!e(f(A)) : not .ground(A) <- .print(open); A = 2.
+!p(A) : p(A) <- .fail.
-!p(A) <- .print(A).
+!is_open(A) : not .ground(A) <- .print(open).
+!n(A) <- !n2(A).
+!n2(A) <- A = 3; .fail(reason(A)).
-!n(A)[reason(R),code(C)] : not .ground(A) <- .print(R," ",C); A = 4.
+!last(0,A) <- A = 9; .fail.
+!last(N,A) <- !last(N-1,A).
-!last(N,A) : not .ground(A) <- .print(N); A = 6.
+!deep(A) <- A = 1; !deeper(B); .print(never).
+!deeper(A) <- A = 2; .fail.
-!deep(A) <- A = 7.
// expect: h
// expect: open
// expect: hd
// expect: ht
// expect: open
// expect: 2
// expect: 5
// expect: open
// expect: 3 .fail(reason(3))
// expect: 4
// expect: 0
// expect: 6
// expect: 1h
// expect: 2h
// expect: 7
