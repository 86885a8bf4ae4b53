@[test] +!asserts_nothing <- .print("quiet").
@[test] +!fails <- .print("before"); .fail; !force_pass.
@[test] +!has_no_plan <- !nobody_can.
@[test] +!waits_for_ever <- .wait({+never}); !force_pass.
@[test] +!never_ends <- !loop.
+!loop <- !loop.
@[test] +!inside_another_goal <- !inner.
+!inner <- !assert_equals(right, wrong).
@[test] +!goes_on_in_the_background <- !!tick; !assert_true(true).
+!tick <- .wait(10); !!tick.
@[test] +!takes_a_minute <- .wait(60000); !force_pass.
@[test] +!mocks_an_agent
    <- !create_mock_agent(ann); .send(ann, tell, v(1)); !wait_idle(ann);
       .send(ann, askOne, v(_), Answer); v(N) = Answer; !assert_equals(1, N).
@[test] +!ends_itself <- .my_name(Me); .kill_agent(Me).
