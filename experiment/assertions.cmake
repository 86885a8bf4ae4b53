# Temporal logic over what a test recorded. Included by CMakeLists.txt beside it.
target_sources(jaywalk_experiment PRIVATE
  assertions/grammar.cpp
  assertions/resolve.cpp
  assertions/robustness.cpp)
