// A plan has its sub-plans whatever its goal was posted by: a loop, a body in a variable, a fork, a
// message, a schedule, an event of its own.
!start.
+!start <- for (.range(I,1,2)) { !o(I) }; !!o(3); .wait(5); !rest.
+!rest <- V = {!o(4); !o(5)}; V;
   while (not done) { +done; !o(6) };
   if (true) { !o(7) };
   !o(8) |&| !o(9);
   .my_name(Me); .send(Me,achieve,o(10)); .wait(20);
   .at("now +1 ms",{+!o(11)}); .wait(20);
   +b(12); ?t(13).
+b(X) <- !o(X).
+?t(X) <- !o(X).
+!o(A) <- !i(A,R); .print(A," ",R). { +!i(K,R) <- R = x. }
// expect: 1 x
// expect: 2 x
// expect: 3 x
// expect: 4 x
// expect: 5 x
// expect: 6 x
// expect: 7 x
// expect: 8 x
// expect: 9 x
// expect: 10 x
// expect: 11 x
// expect: 12 x
// expect: 13 x
