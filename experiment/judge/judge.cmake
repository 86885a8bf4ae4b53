# Signals, situations and metrics of recorded tests, and temporal logic over them. Included by
# CMakeLists.txt above.
# The grammar's rules have the names of their results, so it is compiled by itself.
set_source_files_properties(judge/assertions/grammar.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Tables that tests/tutorial extends are compiled by themselves.
set_source_files_properties(judge/metrics/metrics.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_sources(jaywalk_experiment PRIVATE
  judge/assertions/assertion.cpp
  judge/assertions/grammar.cpp
  judge/assertions/resolve.cpp
  judge/assertions/robustness.cpp
  judge/csv_line.cpp
  judge/metrics/encroachment.cpp
  judge/metrics/impact_speed.cpp
  judge/metrics/metrics.cpp
  judge/metrics/min_distance_time.cpp
  judge/metrics/natural_steps.cpp
  judge/metrics/time_exposed.cpp
  judge/signals/boxes.cpp
  judge/signals/careful_drive.cpp
  judge/signals/collision_course.cpp
  judge/signals/motion.cpp
  judge/signals/nearness.cpp
  judge/signals/places.cpp
  judge/signals/signals.cpp
  judge/situations/items.cpp
  judge/situations/reach_file.cpp
  judge/situations/situations.cpp
  judge/trace_file.cpp)
