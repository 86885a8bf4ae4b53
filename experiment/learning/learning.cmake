# How agents learn from tests. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  learning/episodes.cpp
  learning/rewards.cpp
  learning/training.cpp)
