// .suspended and .intention tell why a goal waits.
// expect: [time(50)]
// expect: [e]
// expect: [f(1)]
// expect: suspend_ia
// expect: not suspended
!main.
+!main <- !!a; !!b; !!c; !!d; .wait(20);
          for (.member(G,[a,b,c])) { .suspended(G,wait(_)[|R]); .print(R) };
          .suspended(d,S); .print(S); .resume(d); .wait(1);
          if (not .suspended(d,_)) { .print("not suspended") }; .drop_desire(c).
+!a <- .wait(50).
+!b <- .wait({+!e},60,_).
+!c <- .wait(f(1)).
+!d <- .suspend; .wait({+never},1,_).
