# Stored tests as files for other programs. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  export/csv.cpp
  export/exporter.cpp
  export/json.cpp
  export/junit.cpp
  export/markdown.cpp
  export/observations.cpp
  export/openscenario/courses.cpp
  export/openscenario/opendrive.cpp
  export/openscenario/openscenario.cpp
  export/openscenario/openscenario_text.cpp
  export/openscenario/playback.cpp
  export/openscenario/road_plan.cpp
  export/postgis.cpp
  export/svg.cpp
  export/traces.cpp)
