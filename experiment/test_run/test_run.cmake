# One test. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  test_run/controller_notes.cpp
  test_run/covered_bins.cpp
  test_run/plan_coverage.cpp
  test_run/simulator_version.cpp
  test_run/tested_vehicles.cpp
  test_run/test_run.cpp
  test_run/prepared_scenario.cpp)
