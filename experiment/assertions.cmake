# What a test recorded as signals, metrics of it, and temporal logic over it. Included by
# CMakeLists.txt beside it.
# The grammar's rules are named as what they make, so it is compiled by itself.
set_source_files_properties(assertions/grammar.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_sources(jaywalk_experiment PRIVATE
  assertions/assertion.cpp
  assertions/assertion_file.cpp
  assertions/grammar.cpp
  assertions/resolve.cpp
  assertions/robustness.cpp
  assertions/words.cpp
  export/junit.cpp
  export/kills_csv.cpp
  findings.cpp
  kills/kills.cpp
  kills/kills_file.cpp
  kills/predictors.cpp
  kills/team.cpp
  per_test.cpp
  metrics/encroachment.cpp
  metrics/impact_speed.cpp
  metrics/max_btn.cpp
  metrics/max_drac.cpp
  metrics/metrics.cpp
  metrics/min_distance.cpp
  metrics/min_pret.cpp
  metrics/min_ttb.cpp
  metrics/min_ttc.cpp
  metrics/naturalness.cpp
  metrics/time_exposed.cpp
  metrics/time_in_road.cpp
  report/explanation_json.cpp
  report/kill_table.cpp
  report/situation_table.cpp
  report/verdict_table.cpp
  signals/boxes.cpp
  signals/careful_driver.cpp
  signals/collision_course.cpp
  signals/motion.cpp
  signals/nearness.cpp
  signals/places.cpp
  signals/signals.cpp
  situations/items.cpp
  situations/situation_table.cpp
  situations/situations.cpp)
