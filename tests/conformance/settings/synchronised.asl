// synchronised=true: messages are always handled by the plans for them; else tell, achieve and signal are short cuts.
// agent sender
!start.
+!start <- .send([plans, direct], tell, p(1)); .send([plans, direct], achieve, g).
// agent plans
// settings: synchronised=true
^!kqml_received(_, P, C, _)[state(executing)] <- .print(P, " ", C).
+p(X)[source(S)] <- .print("told ", X, " by ", S).
+!g[source(S)] <- .print("asked by ", S).
// expect [plans]: tell p(1)
// expect [plans]: told 1 by sender
// expect [plans]: achieve g
// expect [plans]: asked by sender
// agent direct
^!kqml_received(_, P, C, _)[state(executing)] <- .print(P, " ", C).
+p(X)[source(S)] <- .print("told ", X, " by ", S).
+!g[source(S)] <- .print("asked by ", S).
// expect [direct]: told 1 by sender
// expect [direct]: asked by sender
