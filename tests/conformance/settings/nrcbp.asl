// nrcbp=N: only every N-th cycle looks at the world and into the inbox; .perceive looks at the world now.
// environment: board
// agent seldom
// settings: nrcbp=50
!start.
+!start
  <- show(a); .print(shown); if (a) { .print("too early") } else { .print("not yet") };
     .perceive; if (a) { .print("seen now") };
     show(b); if (b) { .print("too early") }; .wait(b); .print("seen later"); .my_name(Me); .send(Me, tell, news);
     for (.range(I, 1, 8)) { if (news) { .print("too early") } }; .wait(news); .print("told").
// expect [seldom]: shown
// expect [seldom]: not yet
// expect [seldom]: seen now
// expect [seldom]: seen later
// expect [seldom]: told
// agent always
!start.
+!start
  <- .wait(c); show(d); if (d) { .print("seen at once") };
     .my_name(Me); .send(Me, tell, news); .wait(news); .print(told).
// expect [always]: seen at once
// expect [always]: told
// agent waker
!start.
+!start <- show(c).
