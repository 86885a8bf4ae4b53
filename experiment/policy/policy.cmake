# Policies that agents learn: their files and learners. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  policy/actor_critic.cpp
  policy/clipped_objective.cpp
  policy/policy.cpp
  policy/policy_file.cpp
  policy/q_table.cpp)
