// environment: board
// What a goal waits for is told by its state: an action, time, an event, a formula, an answer, .suspend.
// expect: act executing []
// expect: act waiting [action(show(p))]
// expect: act executing [action_executed(show(p))]
// expect: act suspended [suspend_ia]
// expect: act resumed [resume_ia]
// expect: act executing []
// expect: act achieved []
!main.
+!main <- !!act; .wait(100); .resume(act).
+!act <- show(p); .suspend.
^!act[state(S)[reason("")]] : S \== pending & S \== finished <- .print("act ",S," []").
^!act[state(S)[reason(R)]] : S \== pending & S \== finished <- .print("act ",S," [",R,"]").
