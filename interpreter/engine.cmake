# The engine: term ← logic ← program ← agent ← actions ← mas, and the compiler from syntax trees.
# Internal actions are plug-ins: a new file in actions/ is found by itself.
file(GLOB_RECURSE JAYWALK_ACTION_SOURCES CONFIGURE_DEPENDS actions/*.cpp)

jaywalk_add_library(engine
  SOURCES
    term/walk.cpp
    term/compare.cpp
    term/heap.cpp
    term/object.cpp
    term/number_text.cpp
    term/print.cpp
    term/program_terms.cpp
    term/symbol.cpp
    logic/action.cpp
    logic/unifier/arithmetic.cpp
    logic/beliefs/belief_base.cpp
    logic/beliefs/belief_update.cpp
    logic/beliefs/constant_percepts.cpp
    logic/beliefs/relation.cpp
    logic/beliefs/remains.cpp
    logic/formula_compiler.cpp
    logic/frame_stack.cpp
    logic/code/head_code.cpp
    logic/machine.cpp
    logic/machine_annotated.cpp
    logic/machine_calls.cpp
    logic/machine_queries.cpp
    logic/machine_rules.cpp
    logic/machine_tests.cpp
    logic/rule_unfolder.cpp
    logic/code/operand.cpp
    logic/beliefs/row_index.cpp
    logic/beliefs/rule_table.cpp
    logic/beliefs/shared_rows.cpp
    logic/unifier/unifier.cpp
    logic/unifier/unifier_apply.cpp
    logic/unifier/unifier_numbers.cpp
    logic/unifier/univ.cpp
    program/code_text.cpp
    program/event_code.cpp
    program/plan.cpp
    program/plan_compiler.cpp
    program/program.cpp
    program/rule_folder.cpp
    program/isolation.cpp
    compile/beginnings.cpp
    compile/compiler.cpp
    compile/goal_patterns.cpp
    compile/kqml_plans.cpp
    compile/plan_reader.cpp
    compile/term_reader.cpp
    compile/translator.cpp
    agent/plans/add_means.cpp
    agent/agent.cpp
    agent/execution/bindings.cpp
    agent/execution/branches.cpp
    agent/execution/change_beliefs.cpp
    agent/plans/choose_plan.cpp
    agent/execution/clear.cpp
    agent/clone.cpp
    agent/plans/customisation.cpp
    agent/cycle/cycle.cpp
    agent/drops.cpp
    agent/cycle/events.cpp
    agent/execution/execute.cpp
    agent/execution/execute_variable.cpp
    agent/goals/failure.cpp
    agent/execution/for_loops.cpp
    agent/garbage.cpp
    agent/goal_copier.cpp
    agent/execution/goal_arguments.cpp
    agent/goals/goals.cpp
    agent/circumstance/intention.cpp
    agent/memory.cpp
    agent/cycle/messages.cpp
    agent/surroundings/observer.cpp
    agent/plans/learned.cpp
    agent/plans/options.cpp
    agent/cycle/perception.cpp
    agent/plans/plan_terms.cpp
    agent/surroundings/services.cpp
    agent/step_guard.cpp
    agent/execution/step_texts.cpp
    agent/goals/waiting.cpp
    coverage/coverage.cpp
    coverage/html.cpp
    coverage/listings.cpp
    coverage/probe_texts.cpp
    coverage/probes.cpp
    coverage/source_coverage.cpp
    embed/agent_functions.cpp
    embed/call.cpp
    embed/ground_literal.cpp
    embed/interpreter.cpp
    embed/observer.cpp
    embed/program_loader.cpp
    embed/project_agents.cpp
    embed/terms.cpp
    explain/explanation.cpp
    explain/near_misses.cpp
    explain/text.cpp
    mas/batches.cpp
    mas/constants.cpp
    mas/workers.cpp
    mas/mail.cpp
    mas/mas.cpp
    mas/memory.cpp
    mas/parallel.cpp
    environment/percepts.cpp
    mas/reach.cpp
    mas/agent_table.cpp
    mas/steps.cpp
    mas/system.cpp
    term/transfer.cpp
    agent_tests/unit_test_goals.cpp
    agent_tests/unit_tests.cpp
    ${JAYWALK_ACTION_SOURCES}
  PUBLIC jaywalk::syntax jaywalk::support
  PRIVATE fmt::fmt PkgConfig::libpcre2)

# Tables that tests/tutorial extends are compiled by themselves.
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/actions/standard_actions.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# The files of the reasoning cycle are compiled as one, so that the compiler can inline across files
# and reads the headers once. The other files are compiled in groups of eight, or alone.
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(hot
    term/compare.cpp term/heap.cpp term/transfer.cpp
    logic/action.cpp logic/beliefs/belief_base.cpp logic/beliefs/relation.cpp logic/beliefs/belief_update.cpp
    logic/frame_stack.cpp logic/machine.cpp logic/machine_annotated.cpp logic/machine_calls.cpp
    logic/machine_queries.cpp
    logic/machine_rules.cpp logic/machine_tests.cpp logic/beliefs/remains.cpp logic/beliefs/row_index.cpp
    logic/beliefs/rule_table.cpp
    logic/unifier/unifier.cpp logic/unifier/unifier_apply.cpp logic/unifier/unifier_numbers.cpp
    agent/plans/add_means.cpp agent/agent.cpp agent/execution/bindings.cpp agent/plans/choose_plan.cpp
    agent/execution/change_beliefs.cpp agent/execution/clear.cpp agent/cycle/cycle.cpp
    agent/cycle/events.cpp agent/execution/execute.cpp agent/execution/goal_arguments.cpp agent/circumstance/intention.cpp agent/cycle/messages.cpp agent/cycle/perception.cpp
    mas/mail.cpp environment/percepts.cpp mas/agent_table.cpp mas/steps.cpp mas/system.cpp)
  set_source_files_properties(${hot} PROPERTIES UNITY_GROUP core)
  if(JAYWALK_UNITY)
    get_target_property(others jaywalk_engine SOURCES)
    list(REMOVE_ITEM others ${hot})
    set(count 0)
    foreach(source IN LISTS others)
      math(EXPR group "${count} / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP others_${group})
      math(EXPR count "${count} + 1")
    endforeach()
  endif()
  set_target_properties(jaywalk_engine PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endif()
