# The scenario of a comparison, read from YAML. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  scenario/assertion_file.cpp
  scenario/files/portable_names.cpp
  scenario/files/program_copies.cpp
  scenario/files/program_text.cpp
  scenario/files/temporary.cpp
  scenario/files/write_file.cpp
  scenario/number_list.cpp
  scenario/scenario.cpp
  scenario/scenario_learning.cpp
  scenario/scenario_schema.cpp
  scenario/scenario_yaml.cpp)
target_link_libraries(jaywalk_experiment PRIVATE yaml-cpp PkgConfig::libmd)
