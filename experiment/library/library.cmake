# What include/jaywalk/ declares, for other programs.
target_sources(jaywalk_experiment PRIVATE
  library/comparison.cpp
  library/judging_rules.cpp
  library/learned_policy.cpp
  library/results_store.cpp
  library/scenario.cpp
  library/test_report.cpp)
