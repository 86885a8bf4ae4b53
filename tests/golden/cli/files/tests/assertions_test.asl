{ include("$jasonJar/test/jason/inc/tester_agent.asl") }

@[test]
+!all_pass
    <- !assert_equals(1, 1); !assert_equals([a, b], [b, a]); !assert_equals(0.3, 0.1 + 0.2, 0.001);
       !assert_not_equals(1, "1"); !assert_true(3 > 2); !assert_false(3 < 2);
       !assert_contains([1, 2], 2); !assert_not_contains([1, 2], 3); !assert_greater_than(2, 1);
       !assert_greater_than_equals(2, 2); !assert_between(2, 1, 3); !force_pass.

@[test]
+!all_fail
    <- !assert_equals(1, 2); !assert_equals("a", a); !assert_equals([a, b], [a]);
       !assert_equals(0.3, 0.4, 0.001);
       !assert_not_equals(f(X), f(X)); !assert_true(wet); !assert_false(3 > 2);
       !assert_contains([1, 2], 3); !assert_not_contains([1, 2], 2); !assert_greater_than(1, 1);
       !assert_greater_than_equals(1, 2); !assert_between(4, 1, 3); !assert_between(a, 1, 3);
       !force_failure("on purpose").
