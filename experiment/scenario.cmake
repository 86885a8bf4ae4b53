# The scenario and the trial: what a comparison runs. Included by CMakeLists.txt beside it.
target_sources(jaywalk_experiment PRIVATE
  carry_over.cpp
  code_lines.cpp
  covered_bins.cpp
  feedback.cpp
  plan_coverage.cpp
  program_copies.cpp
  scenario.cpp
  scenario_actors.cpp
  scenario_av.cpp
  scenario_defects.cpp
  scenario_parameters.cpp
  scenario_presets.cpp
  scenario_reader.cpp
  scenario_road.cpp
  scenario_schema.cpp
  scenario_world.cpp
  scenario_yaml.cpp
  tested_vehicles.cpp
  trial.cpp
  trial_prepare.cpp)
target_link_libraries(jaywalk_experiment PUBLIC jaywalk::env PRIVATE yaml-cpp)
