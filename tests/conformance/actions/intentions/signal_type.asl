// A signal of the type type_signal has the annotation signal; other types mean nothing.
!go.
+!go <- .signal({+b(1)},type_signal); .wait(10); .signal({+b(2)},other); .wait(10);
        .findall(X,b(X),L); .print(L).
+b(X)[signal,source(S)] <- .print("signal ",X," ",S).
+b(X)[source(S)] <- .print("plain ",X," ",S).
// expect: signal 1 self
// expect: plain 2 self
// expect: []
