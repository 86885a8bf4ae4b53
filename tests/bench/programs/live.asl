// Everything that comes and goes: intentions, beliefs, strings, lists, messages.
n(1000).
!start.
+!start <- +step(0); !live.
+!live : step(N) & n(N).
+!live : step(N)
  <- -+step(N + 1);
     .concat("text ", N, Text);
     +seen(Text, [N, N + 1])[weight(N)];
     -seen(Text, _);
     !!spark(N);
     .send(self, tell, echo(N mod 7));
     !live.
+!spark(N) : N mod 2 == 0 <- +bright.
+!spark(_) <- -bright.
+echo(X)[source(S)] <- -echo(X)[source(S)].
