// A step: two beliefs change, the change of position triggers a plan whose context reads three
// beliefs, a rule and a negation.
n(100).
target(1000000).
lane(0). lane(1). lane(2).
speed(2).
hazard(17).
danger(X, D) :- hazard(H) & D = H - X & D > 0 & D < 3.
steps(0).
!start.
+!start <- +at(0, 0); !drive.
+!drive : steps(S) & n(N) & S >= N.
+!drive : at(X, L) & speed(V) & steps(S)
  <- Next = (X + V) mod 100;
     Done = S + 1;
     -+steps(Done);
     -at(X, L);
     +at(Next, L);
     !drive.
+at(X, L) : danger(X, _D) & lane(K) & not K = L <- +swerved(X, K).
+at(X, _) : target(X) <- +arrived.
+at(_, L) : lane(L) & speed(V) & V > 0.
