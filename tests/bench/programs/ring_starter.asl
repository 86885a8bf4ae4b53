// Tells each of the 500 who is next, then lets the token go.
!start.
+!start : n(N)
  <- for (.range(I, 1, 500)) {
       .concat("thread", I, Name);
       .concat("thread", I mod 500 + 1, Next);
       .term2string(NextAgent, Next);
       .send(Name, tell, next(NextAgent));
     }
     .send(thread1, achieve, token(N)).
