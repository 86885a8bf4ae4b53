# Stored tests as files for other programs. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  export/courses.cpp
  export/exporter.cpp
  export/observations.cpp
  export/opendrive.cpp
  export/openscenario.cpp
  export/openscenario_text.cpp
  export/playback.cpp
  export/postgis.cpp
  export/program.cpp
  export/road_plan.cpp
  export/traces.cpp
  export/validate.cpp
  trace_file.cpp)
