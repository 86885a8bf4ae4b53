// What has suspended itself, and is suspended again from outside, goes on after one .resume.
!start.
+!job(N) <- .print("s ",N); .suspend; .print("done ",N).
+!start <- !!job(1); .wait(20); .suspend(job(1)); .wait(10); .resume(job(1)); .wait(50); .print(end);
  !!job(2); .wait(10); .suspend(job(2)); .suspend(job(2)); .resume(job(2)); .wait(10); .print(end2); .resume(job(2)).
// expect: s 1
// expect: done 1
// expect: end
// expect: s 2
// expect: done 2
// expect: end2
