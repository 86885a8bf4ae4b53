# One test. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  trial/covered_bins.cpp
  trial/plan_coverage.cpp
  trial/simulator_version.cpp
  trial/tested_vehicles.cpp
  trial/trial.cpp
  trial/trial_prepare.cpp)
