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
  export/openscenario/validate.cpp
  export/postgis.cpp
  export/svg.cpp
  export/traces.cpp)

# With sanitizers GCC 12 warns of std::regex's own code (GCC bug 105562).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND JAYWALK_SANITIZERS)
  set_source_files_properties(export/openscenario/validate.cpp PROPERTIES
                              COMPILE_OPTIONS -Wno-maybe-uninitialized)
endif()
