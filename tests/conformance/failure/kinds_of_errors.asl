// Each kind of failure has its name.
!start.
+!start <-
  !try({ .fail }); !try({ .fail(why(1)) }); !try({ 1 > 2 }); !try({ ?missing });
  !try({ !missing }); !try({ !known(2) }); !try({ .nth(5, [a], _) }); !try({ act }).
+!try(B) <- B; .print("never").
-!try(_)[error(E)] <- .print(E).
+!known(1).
// expect: ia_failed
// expect: internal_action
// expect: constraint_failed
// expect: test_goal_failed
// expect: no_relevant
// expect: no_applicable
// expect: internal_action
// expect: action_failed
