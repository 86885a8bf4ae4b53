{ include("tester_agent.asl") }
{ include("counter.asl") }

@[test]
+!counts_from_zero <- ?count(N); !assert_equals(0, N).

@increments[test, atomic]
+!test_increment <- !increment; !increment; ?count(N); !assert_equals(2, N).

// Each test begins anew.
@[test]
+!increments_by_a_number <- !increment_by(3); !assert_true(count(3)); !assert_false(count(2)).

+!not_a_test <- !force_failure("never run").
