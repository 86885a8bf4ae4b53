// What each action on intentions and goals does ordinarily, at the boundary, and when it fails.
!start.
+!start
  <- for (.member(A, [".fail", ".wait", ".at", ".signal", ".intend", ".desire", ".intention", ".current_intention",
                      ".suspend", ".resume", ".suspended", ".drop_intention", ".drop_desire", ".drop_event",
                      ".drop_future_intention", ".succeed_goal", ".fail_goal", ".done",
                      ".drop_all_events", ".drop_all_desires", ".drop_all_intentions"])) {
       !ordinary(A); !boundary(A); !failure(A)
     }.
-!failure(A)[error(E)] <- .print(A, " ", E).
+!long(X) <- .wait(60); .print("long ", X, " ends").
+!later(X) <- .wait(60); !short(X).
+!short(X) <- .print("short ", X).
+!inner(X) <- .wait(1000); .print("never").
-!inner(X) <- .print("inner ", X, " failed").
+!outer(X) <- !inner(X); .print("outer ", X, " goes on").
+b(X) <- .print("event ", X).

+!ordinary(".fail") <- if (.fail | true) { .print("no solution") }.
+!boundary(".fail") <- if (not .fail(why(1))) { .print("nor so") }.
+!failure(".fail") <- .fail(error_msg("as asked")).
+!ordinary(".wait") <- .wait(100); .wait({ +none }, 20, T); .print(T).
+!boundary(".wait") <- .wait(0); .wait(true); .wait(false, 0, T); .print("at once").
+!failure(".wait") <- .wait({ +none }, 20).
+!ordinary(".at") <- .at("now +50 ms", { +!short(at) }); .print("at once"); .wait(100).
+!boundary(".at") <- .at("now +0", { +!short(now) }); .at("now +1 s", { +b(at) }); .wait(2000).
+!failure(".at") <- .at("tomorrow", { +!short(never) }).
+!ordinary(".signal") <- .signal({ +b(signal) }); .wait(20).
+!boundary(".signal") <- .signal({ +nobody(1) }); .signal({ +!short(signal) }); .wait(20).
+!failure(".signal") <- .signal(5).
+!ordinary(".intend") <- !!long(intend); .wait(20); .intend(long(X)); .print(X); .wait(100).
+!boundary(".intend") <- .intend(start); .findall(X, .intend(long(X)), L); .print(L).
+!failure(".intend") <- .intend(none).
+!ordinary(".desire") <- !!short(desire); .desire(short(X)); .print(X); .wait(20).
+!boundary(".desire") <- .desire(start); .findall(X, .desire(short(X)), L); .print(L).
+!failure(".desire") <- .desire(none).
+!ordinary(".intention") <- .findall(S, .intention(_, S), L); .print(L).
+!boundary(".intention") <- .intention(I, S, [im(_, { +!boundary(A)[|_] }, _, _)|_], current); .print(S, A).
+!failure(".intention") <- .intention(none, _).
+!ordinary(".current_intention") <- .current_intention(intention(_, [im(_, { +!ordinary(A)[|_] }, _, _)|_])); .print(A).
+!boundary(".current_intention") <- .current_intention(intention(_, S)); .length(S, N); .print(N).
+!failure(".current_intention") <- .current_intention(none).
+!ordinary(".suspend") <- !!long(suspend); .wait(20); .suspend(long(_)); .wait(100); .print("waits"); .resume(long(_)); .wait(100).
+!boundary(".suspend") <- .suspend(none); .print("none").
+!failure(".suspend") <- .suspend(a, b).
+!ordinary(".resume") <- !!self; .wait(20); .resume(self); .wait(20).
+!boundary(".resume") <- .resume(none); .resume(start); .print("none").
+!failure(".resume") <- .resume.
+!self <- .suspend; .print("resumed").
+!ordinary(".suspended") <- !!self; .wait(20); .suspended(self, R); .print(R); .drop_intention(self).
+!boundary(".suspended") <- !!long(suspended); .wait(20); .suspended(long(_), wait(_)[time(T)]); .print(T); .wait(100).
+!failure(".suspended") <- .suspended(start, _).
+!ordinary(".drop_intention") <- !!long(1); !!long(2); .wait(20); .drop_intention(long(1)); .wait(100).
+!boundary(".drop_intention") <- .drop_intention(none); !!itself; .wait(20); .print("no other").
+!failure(".drop_intention") <- .drop_intention(3).
+!itself <- .drop_intention; .print("never").
+!ordinary(".drop_desire") <- !!long(1); .wait(20); !!long(2); .drop_desire(long(_)); .wait(100); .print("nothing is left").
+!boundary(".drop_desire") <- .drop_desire(none); .print("none").
+!failure(".drop_desire") <- .drop_desire(3).
+!ordinary(".drop_event") <- !event(1); .wait(20).
@event[atomic] +!event(X) <- !!short(X); !!short(X + 1); .drop_event(short(X)).
+!boundary(".drop_event") <- .drop_event(none); !!long(event); .wait(20); .drop_event(long(_)); .wait(100).
+!failure(".drop_event") <- .drop_event(3).
+!ordinary(".drop_future_intention") <- !!later(1); !!long(2); .wait(20); .drop_future_intention(short(_)); .wait(100).
+!boundary(".drop_future_intention") <- .drop_future_intention(none); .print("none").
+!failure(".drop_future_intention") <- .drop_future_intention(3).
+!ordinary(".succeed_goal") <- !!outer(1); .wait(20); .succeed_goal(inner(_)); .wait(20).
+!boundary(".succeed_goal") <- .succeed_goal(none); .print("none").
+!failure(".succeed_goal") <- .succeed_goal(3).
+!ordinary(".fail_goal") <- !!outer(2); .wait(20); .fail_goal(inner(_)); .wait(20).
+!boundary(".fail_goal") <- .fail_goal(none); .print("none").
+!failure(".fail_goal") <- .fail_goal(3).
+!ordinary(".done") <- .print("ends here"); .done; .print("never").
+!boundary(".done") <- .done(none); .print("none").
+!failure(".done") <- .done(a, b).
+!ordinary(".drop_all_events") <- !events; .wait(20); .print("no event").
@events[atomic] +!events <- !!short(1); !!short(2); .drop_all_events.
+!boundary(".drop_all_events") <- .drop_all_events; .print("none").
+!failure(".drop_all_events") <- if (not .drop_all_events) { .print("bad") } else { .print("never fails") }.
+!ordinary(".drop_all_desires") <- !!long(1); .wait(20); !!short(2); .drop_all_desires; .wait(100); .print("no desire").
+!boundary(".drop_all_desires") <- .drop_all_desires; .print("none").
+!failure(".drop_all_desires") <- if (not .drop_all_desires) { .print("bad") } else { .print("never fails") }.
+!ordinary(".drop_all_intentions") <- !!long(1); .wait(20); .drop_all_intentions; .wait(100); .print("no other").
+!boundary(".drop_all_intentions") <- .drop_all_intentions; .print("itself goes on").
+!failure(".drop_all_intentions") <- if (not .drop_all_intentions) { .print("bad") } else { .print("never fails") }.
// expect: no solution
// expect: nor so
// expect: .fail internal_action
// expect: 20
// expect: at once
// expect: .wait wait_timeout
// expect: at once
// expect: short at
// expect: short now
// expect: event at
// expect: .at internal_action
// expect: event signal
// expect: short signal
// expect: .signal unknown
// expect: intend
// expect: long intend ends
// expect: []
// expect: .intend ia_failed
// expect: short desire
// expect: desire
// expect: []
// expect: .desire ia_failed
// expect: [running]
// expect: running.intention
// expect: .intention ia_failed
// expect: .current_intention
// expect: 2
// expect: .current_intention ia_failed
// expect: waits
// expect: long suspend ends
// expect: none
// expect: .suspend wrong_arguments
// expect: resumed
// expect: none
// expect: .resume wrong_arguments
// expect: suspend_ia
// expect: 60
// expect: long suspended ends
// expect: .suspended ia_failed
// expect: long 2 ends
// expect: no other
// expect: .drop_intention wrong_arguments
// expect: nothing is left
// expect: none
// expect: .drop_desire wrong_arguments
// expect: short 2
// expect: long event ends
// expect: .drop_event wrong_arguments
// expect: long 2 ends
// expect: none
// expect: .drop_future_intention wrong_arguments
// expect: outer 1 goes on
// expect: none
// expect: .succeed_goal wrong_arguments
// expect: inner 2 failed
// expect: outer 2 goes on
// expect: none
// expect: .fail_goal wrong_arguments
// expect: ends here
// expect: none
// expect: .done wrong_arguments
// expect: no event
// expect: none
// expect: never fails
// expect: no desire
// expect: none
// expect: never fails
// expect: no other
// expect: itself goes on
// expect: never fails
