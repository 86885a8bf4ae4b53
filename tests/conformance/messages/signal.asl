// A signal is an event with the annotation signal; nothing is believed.
// agent sender
!go.
+!go <- .send(receiver,signal,alarm(3)).
// agent receiver
// expect [receiver]: alarm 3 of sender
// expect [receiver]: signal
// expect [receiver]: []
+alarm(N)[source(S)|As] <- .print("alarm ",N," of ",S); .member(signal,As); .print(signal);
                           .findall(X,alarm(X),L); .print(L).
