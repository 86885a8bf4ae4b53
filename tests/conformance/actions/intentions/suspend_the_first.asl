// .suspend and .resume bind at the first goal that matches, and touch no others.
!start.
+!job(N) <- .wait(100); .print("done").
+!start <- !!job(1); !!job(2); !!job(3); .wait(20); .suspend(job(X)); ?ground(X); .wait(150);
  .print("two are done"); .resume(job(Z)); .wait(50); ?same(X,Z); .print(same);
  !!job(4); !!job(5); .wait(20); .suspend(job(4)); .suspend(job(5)); .resume(job(W)); ?ground(W); .wait(200);
  .print("one is done"); .resume(job(_)); .wait(50); .print(end).
ground(X) :- .ground(X). same(X,X).
// expect: done
// expect: done
// expect: two are done
// expect: done
// expect: same
// expect: done
// expect: one is done
// expect: done
// expect: end
