# A comparison from its request to its results. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  run/comparison_request.cpp
  run/comparison_tables.cpp
  run/run_comparison.cpp)
